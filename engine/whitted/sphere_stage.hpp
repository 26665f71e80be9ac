// SPDX-License-Identifier: MIT
/// @file
/// How a ray passes a sphere: the geometric solution, which puts the square root off (source 004,
/// "Sphere Background Math"). Both searches use it, for the nearest hit and for a shadow.
#pragma once

#include "engine/whitted/formats.hpp"
#include "engine/whitted/frame.hpp"

namespace raymarch::engine::whitted
{

/// A ray from `from` and a sphere. What stands below `behind` counts only where that is false.
struct Approach
{
    Wide squared_distance; ///< of the centre from the ray's origin
    bool from_inside;      ///< the origin is inside the sphere
    bool behind;           ///< the point nearest to the centre is
    Word along;            ///< how far along the ray that point is
    Wide half_chord;       ///< squared; negative where the ray misses
};

[[nodiscard]] Approach approach(const Vector& from, const Vector& direction,
                                const Sphere& sphere) noexcept;

/// How far along the ray its surface is: where the ray enters, or leaves if it began inside. Only
/// for a ray that meets the sphere.
[[nodiscard]] Word distance_to_surface(const Approach& to) noexcept;

/// The unit normal, outwards, at a point of the surface.
[[nodiscard]] Vector sphere_normal(const Sphere& sphere, const Vector& point) noexcept;

} // namespace raymarch::engine::whitted
