// SPDX-License-Identifier: MIT
/// @file
/// The stages composed: a frame in, a row of pixels out (docs/engine/fractal.md).
#pragma once

#include "engine/fractal/frame.hpp"
#include "engine/model.hpp"

#include <cstdint>
#include <span>

namespace raymarch::engine::fractal
{

/// See Picture::draw. A step is one evaluation of the distance: at most 32 a pixel, none for a
/// pixel that the checkerboard leaves as it was.
void draw_row(const Frame& frame, RowOf row, std::span<std::uint8_t> pixels,
              std::span<PixelCost> costs) noexcept;

/// See Picture::frames: four with the checkerboard, else one.
[[nodiscard]] unsigned frames_of_a_still(const Frame& frame) noexcept;

} // namespace raymarch::engine::fractal
