// SPDX-License-Identifier: MIT
/// @file
/// The one interface of every accelerator's model: register words in, pixels out.
#pragma once

#include "engine/image.hpp"
#include "protocol/parameters.hpp"

#include <cstdint>
#include <span>

namespace raymarch::engine
{

/// Which row of which picture.
struct RowOf
{
    PictureSize size;
    std::uint16_t y; ///< from the top
};

/// One accelerator's computation. Pure: the same words and row give the same bytes, on every
/// machine and from any number of threads.
struct Model
{
    const protocol::Accelerator* description;

    /// Draws one row: `pixels` holds 3 * width bytes. Returns the clock cycles that one ray unit of
    /// the source's hardware spends on it in scene queries.
    std::uint64_t (*draw_row)(std::span<const std::uint32_t> words, RowOf row,
                              std::span<std::uint8_t> pixels) noexcept;
};

} // namespace raymarch::engine
