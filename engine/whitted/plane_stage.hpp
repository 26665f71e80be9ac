// SPDX-License-Identifier: MIT
/// @file
/// How a ray meets a plane, and what the plane looks like there (source 004, "Plane Background
/// Math").
#pragma once

#include "engine/whitted/formats.hpp"
#include "engine/whitted/frame.hpp"

namespace raymarch::engine::whitted
{

/// How far along a ray a plane is.
struct PlaneDistance
{
    bool away;     ///< parallel, or seen from behind: planes have one side; no distance
    Word speed;    ///< direction . normal
    Word height;   ///< -(from . normal) - D
    Word distance; ///< may be negative or too small to count
};

[[nodiscard]] PlaneDistance plane_distance(const Vector& from, const Vector& direction,
                                           const Plane& plane) noexcept;

/// Not behind the ray's origin and not so near that it is the plane the ray has just left.
[[nodiscard]] bool counts(Word plane_distance) noexcept;

/// Says whether a bounded plane reaches to this point.
[[nodiscard]] bool within_limits(const Plane& plane, const Vector& point) noexcept;

/// Its colour at a point: a quarter of it on the dark squares of a checkerboard.
[[nodiscard]] Colour plane_colour(const Plane& plane, const Vector& point) noexcept;

} // namespace raymarch::engine::whitted
