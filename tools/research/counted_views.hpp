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

/// The words of the defaults after these changes, one after the other; each is in the syntax of
/// SET.
[[nodiscard]] protocol::Words words_with(const Accelerator& accelerator,
                                         std::initializer_list<std::string_view> changes);

/// The settings of a preset that exists.
[[nodiscard]] std::string_view settings_of(const Accelerator& accelerator, std::string_view preset);

/// The frames of a still, drawn with so many threads.
[[nodiscard]] CountedView drawn(const Accelerator& accelerator, const protocol::Words& words,
                                PictureSize size, unsigned threads);

[[nodiscard]] double pixels_of(PictureSize size);

/// The head of a Markdown table whose columns are divided by `|`.
[[nodiscard]] std::string head(std::string_view columns);

} // namespace raymarch::tools
