// SPDX-License-Identifier: MIT
/// @file
/// The controller (source 001, section IV, Fig. 3): which clock hands which pixel to which ray
/// unit.
#pragma once

#include "engine/fractal/frame.hpp"
#include "engine/model.hpp"

#include <cstdint>
#include <span>

namespace raymarch::engine::fractal
{

/// See Picture::cycles: the clock cycles from the start of one frame to the start of the next: the
/// controller's own rules, pixel by pixel. `units` from 1 to 255; a pixel has at most 32
/// evaluations.
[[nodiscard]] std::uint64_t frame_cycles(const Frame& frame, RowOf last_row,
                                         std::span<const PixelCost> costs, unsigned units) noexcept;

} // namespace raymarch::engine::fractal
