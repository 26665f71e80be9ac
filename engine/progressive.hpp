// SPDX-License-Identifier: MIT
/// @file
/// A picture in passes, coarse first: each pixel is drawn once, with its final value.
#pragma once

#include "engine/image.hpp"
#include "engine/model.hpp"

#include <array>
#include <cstdint>
#include <span>

namespace raymarch::engine
{

/// The pixels (x + i * step, y + j * step).
struct Pass
{
    std::uint16_t x;
    std::uint16_t y;
    std::uint16_t step;
    std::uint16_t grid; ///< with it every pixel of a grid this wide is drawn; 0: not yet
};

/// A group's passes draw what lies between the grid before it: on rows, on columns, on neither.
inline constexpr std::array passes = {
    Pass{0, 0, 8, 8},                                     //
    Pass{4, 0, 8, 0}, Pass{0, 4, 8, 0}, Pass{4, 4, 8, 4}, //
    Pass{2, 0, 4, 0}, Pass{0, 2, 4, 0}, Pass{2, 2, 4, 2}, //
    Pass{1, 0, 2, 0}, Pass{0, 1, 2, 0}, Pass{1, 1, 2, 1},
};

/// The pixels of the first pass are this part of all.
inline constexpr unsigned first_pass_share = passes[0].step * passes[0].step;

/// Empty where the picture is too small to have such pixels.
[[nodiscard]] constexpr Region region_of(const Pass& pass, PictureSize size,
                                         std::uint32_t frame = 0) noexcept
{
    const bool none = pass.x >= size.width || pass.y >= size.height;
    return {.size = size,
            .x = pass.x,
            .y = pass.y,
            .width = static_cast<std::uint16_t>(none ? 0 : size.width - pass.x),
            .height = static_cast<std::uint16_t>(none ? 0 : size.height - pass.y),
            .step = pass.step,
            .frame = frame};
}

/// Shows a picture of which a grid has been drawn: each of its pixels becomes a square.
/// `shown` has the size of `drawn`.
inline void spread(const Image& drawn, unsigned grid, Image& shown) noexcept
{
    const std::size_t width = drawn.size.width;
    for (std::size_t y = 0; y < drawn.size.height; ++y)
        for (std::size_t x = 0; x < width; ++x) {
            const std::size_t from = bytes_per_pixel * ((y - y % grid) * width + x - x % grid);
            for (std::size_t i = 0; i < bytes_per_pixel; ++i)
                shown.rgb[bytes_per_pixel * (y * width + x) + i] = drawn.rgb[from + i];
        }
}

} // namespace raymarch::engine
