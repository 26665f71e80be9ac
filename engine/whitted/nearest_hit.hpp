// SPDX-License-Identifier: MIT
/// @file
/// What a ray hits first: all spheres, the light among them, and only where it misses them all the
/// planes.
#pragma once

#include "engine/whitted/cycles.hpp"
#include "engine/whitted/formats.hpp"
#include "engine/whitted/frame.hpp"

#include <cstdint>

namespace raymarch::engine::whitted
{

inline constexpr std::uint8_t no_sphere = 0xFF;

/// A ray from the eye, or one that a surface reflects.
struct Ray
{
    Vector origin;
    Vector direction; ///< a unit vector
    bool reflected = false;
    std::uint8_t leaves = no_sphere; ///< the sphere that reflects it
};

struct Hit
{
    enum class What : std::uint8_t { Nothing, EyeInside, Sphere, Plane };
    What what = What::Nothing;
    std::uint8_t index = 0; ///< of the sphere or plane
    Word distance{};
    Vector point{};
    cycles::Cycles cycles = 0; ///< that the search took
};

[[nodiscard]] Hit nearest_hit(const Frame& frame, const Ray& ray) noexcept;

} // namespace raymarch::engine::whitted
