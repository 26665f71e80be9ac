// SPDX-License-Identifier: MIT
/// @file
/// The stages composed: a frame in, a row of pixels out (docs/engine/mandelbulb.md).
#pragma once

#include "engine/mandelbulb/frame.hpp"
#include "engine/model.hpp"

#include <cstdint>
#include <span>

namespace raymarch::engine::mandelbulb
{

/// See Picture::draw. A step is one evaluation of the distance.
void draw_row(const Frame& frame, RowOf row, std::span<std::uint8_t> pixels,
              std::span<PixelCost> costs) noexcept;

/// See Picture::cycles: a unit is one pipeline of five cores, which takes an evaluation every five
/// cycles and is filled once; for N = 32 it has the source's 1096 stages.
std::uint64_t frame_cycles(const Frame& frame, RowOf last_row, std::span<const PixelCost> costs,
                           unsigned units) noexcept;

} // namespace raymarch::engine::mandelbulb
