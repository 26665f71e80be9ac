// SPDX-License-Identifier: MIT
/// @file
/// One pixel: its samples, their sum, and the word that the frame memory holds.
#pragma once

#include "engine/model.hpp"
#include "engine/whitted/frame.hpp"

#include <array>
#include <cstdint>

namespace raymarch::engine::whitted
{

/// A word of the frame memory.
struct FrameWord
{
    bool light = false;
    std::array<std::uint8_t, 3> channels{}; ///< red, green, blue, 5 bits each
    bool operator==(const FrameWord&) const = default;
};

struct Pixel
{
    FrameWord word;
    PixelCost cost; ///< clock cycles and rays
};

/// Pixel (x, y) of a picture, from the top left; both may be one beyond it.
[[nodiscard]] Pixel draw_pixel(const Frame& frame, PictureSize size, unsigned x,
                               unsigned y) noexcept;

/// What the display shows: the upper 8 of the converter's 10 bits, of which the lower 5 are the
/// light's flag.
[[nodiscard]] std::array<std::uint8_t, 3> displayed(const FrameWord& word) noexcept;

} // namespace raymarch::engine::whitted
