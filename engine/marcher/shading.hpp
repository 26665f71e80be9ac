// SPDX-License-Identifier: MIT
/// @file
/// The shading stage (source 000, §4.1.7): Lambert and an ambient term that grows towards the sky.
#pragma once

#include "engine/marcher/formats.hpp"

#include <array>
#include <cstdint>

namespace raymarch::engine::marcher
{

/// 1/4 * (1/2 + 1/2 * max(n.y, 0)) + 3/4 * max(n.l, 0), floored term by term: 1/8 to about 1.
[[nodiscard]] Coordinate brightness(const Point& normal, const Point& light) noexcept;

/// colour (Q0.10) times brightness, truncated to 8 bits and held at 255: the source's adder wraps
/// at white, which is a fault.
[[nodiscard]] std::array<std::uint8_t, 3> shade(const std::array<std::uint16_t, 3>& colour,
                                                Coordinate brightness) noexcept;

} // namespace raymarch::engine::marcher
