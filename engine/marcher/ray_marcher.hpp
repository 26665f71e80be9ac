// SPDX-License-Identifier: MIT
/// @file
/// The ray marcher stage (source 000, §4.1.4, Fig. 6, 7): sphere tracing along one ray.
#pragma once

#include "engine/marcher/formats.hpp"
#include "engine/marcher/scene_query.hpp"

namespace raymarch::engine::marcher
{

/// How a ray ended.
struct March
{
    bool hit = false;
    int queries = 0; ///< scene queries, 1 to max_steps
    Point point{};   ///< where the last one was made
};

/// Follows origin + direction * t. After each query t grows by the distance d; then the ray ends:
/// as a miss when t > max_distance or max_steps queries were made, else as a hit when d <
/// surface_distance.
[[nodiscard]] March march(const Point& origin, const Point& direction, Distance distance) noexcept;

} // namespace raymarch::engine::marcher
