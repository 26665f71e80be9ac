// SPDX-License-Identifier: MIT
/// @file
/// The stages composed: words in, a row of pixels out (docs/engine/fractal.md).
#pragma once

#include "engine/fractal/frame.hpp"
#include "engine/model.hpp"

#include <cstdint>
#include <span>

namespace raymarch::engine::fractal
{

/// See Model. A step is one evaluation of the distance: at most 32 a pixel, none for a pixel that
/// the checkerboard leaves as it was.
void draw_row(const Frame& frame, RowOf row, std::span<std::uint8_t> pixels,
              std::span<PixelCost> costs) noexcept;

/// See Model: four with the checkerboard, else one.
[[nodiscard]] unsigned frames_of_a_still(const Frame& frame) noexcept;

// The same from words, and the cycles of controller.hpp.
void draw_row(WordSpan words, RowOf row, std::span<std::uint8_t> pixels,
              std::span<PixelCost> costs) noexcept;
[[nodiscard]] std::uint64_t frame_cycles(WordSpan words, RowOf last_row,
                                         std::span<const PixelCost> costs, unsigned units) noexcept;
[[nodiscard]] unsigned frames_of_a_still(WordSpan words) noexcept;

} // namespace raymarch::engine::fractal
