// SPDX-License-Identifier: MIT
/// @file
/// The surface vectors stage (source 000, §4.1.6): the normal and the direction to the light.
#pragma once

#include "engine/marcher/formats.hpp"
#include "engine/marcher/scene_query.hpp"

namespace raymarch::engine::marcher
{

/// The unit normal at `p`: the gradient by four taps at the corners of a tetrahedron, normalised.
/// Zero where the four distances cancel out.
[[nodiscard]] Point surface_normal(const Point& p, Distance distance) noexcept;

/// The unit vector from `p` to the light; zero where they coincide.
[[nodiscard]] Point light_direction(const Point& p, const Point& light) noexcept;

} // namespace raymarch::engine::marcher
