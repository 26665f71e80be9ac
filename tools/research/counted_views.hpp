// SPDX-License-Identifier: MIT
/// @file
/// Draws views by name and counts their cycles, for the tables of cycle_tables.
#pragma once

#include "cli/frame_counts.hpp"
#include "protocol/accelerators.hpp"
#include "protocol/picture_size.hpp"
#include "protocol/registers.hpp"

#include <initializer_list>
#include <string>
#include <string_view>

namespace raymarch::tools
{

using cli::CountedView;
using cli::four_digits;
using cli::Mean;
using protocol::Accelerator;
using protocol::PictureSize;

/// Returns the words of the defaults after these changes in order; each is in the syntax of SET.
[[nodiscard]] protocol::Words words_with(const Accelerator& accelerator,
                                         std::initializer_list<std::string_view> changes);

/// Returns the settings of an existing preset.
[[nodiscard]] std::string_view settings_of(const Accelerator& accelerator, std::string_view preset);

/// Draws the frames of a still.
[[nodiscard]] CountedView drawn(const Accelerator& accelerator, const protocol::Words& words,
                                PictureSize size, unsigned threads);

[[nodiscard]] double pixels_of(PictureSize size);

/// Makes the head of a Markdown table; `|` separates its columns.
[[nodiscard]] std::string head(std::string_view columns);

} // namespace raymarch::tools
