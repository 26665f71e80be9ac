// SPDX-License-Identifier: MIT
/// @file
/// The texture sampler and the end of the marcher's state machine (source 001, sections V.B and
/// V.D): how grey a ray is.
#pragma once

#include "engine/fractal/formats.hpp"
#include "engine/fractal/frame.hpp"
#include "engine/fractal/ray_marcher.hpp"

#include <cstdint>

namespace raymarch::engine::fractal
{

/// The depth with bricks of 1/8 x 1/16 laid over it: two steps nearer inside a brick, `depth` in
/// the joint. Modulo 32, so that the nearest bricks come out black in their middle.
[[nodiscard]] std::uint8_t brick(const Point& p, std::uint8_t depth) noexcept;

/// How far `depth` is, with 15 for the nearest: 5 bits, the last of them dithered by the parity of
/// the pixel or dropped.
[[nodiscard]] std::uint8_t grey(const Frame& frame, const March& ray, std::uint16_t x,
                                std::uint16_t y) noexcept;

} // namespace raymarch::engine::fractal
