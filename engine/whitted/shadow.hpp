// SPDX-License-Identifier: MIT
/// @file
/// The shadow ray: the way to the light, and whether a sphere stands in it. Planes cast no shadow,
/// nor does the light.
#pragma once

#include "engine/whitted/cycles.hpp"
#include "engine/whitted/formats.hpp"
#include "engine/whitted/frame.hpp"

#include <cstdint>

namespace raymarch::engine::whitted
{

/// From a point to the light.
struct WayToLight
{
    Vector direction;      ///< a unit vector
    Word distance;         ///< a multiple of 16 raw
    Wide squared_distance; ///< a multiple of 256 raw
};

/// Right for lights nearer than 1024.
[[nodiscard]] WayToLight way_to_light(const Vector& point, const Vector& light) noexcept;

struct ShadowSearch
{
    bool blocked = false;
    cycles::Cycles cycles = 0;
};

/// Looks for the first sphere in the way. `own` is the sphere that the point is on, or no_sphere;
/// for the defect StaleSphere the sphere last hit in the sample, 0 before the first.
[[nodiscard]] ShadowSearch search_shadow(const Frame& frame, const Vector& point,
                                         const WayToLight& way, std::uint8_t own) noexcept;

} // namespace raymarch::engine::whitted
