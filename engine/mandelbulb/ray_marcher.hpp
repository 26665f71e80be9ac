// SPDX-License-Identifier: MIT
/// @file
/// The ray marcher (source 003, §II, §IV.A, Listing 1, Fig. 2), with the dynamic epsilon.
#pragma once

#include "engine/mandelbulb/distance.hpp"
#include "engine/mandelbulb/formats.hpp"

#include <algorithm>
#include <cstdint>

namespace raymarch::engine::mandelbulb
{

enum class Outcome : std::uint8_t {
    Hit,
    Miss,
    Limit ///< all evaluations made without either: coloured as a hit
};

/// When a ray ends.
struct Limits
{
    int epsilon_shift = 12; ///< a hit is at the 2^-shift-th part of the first distance, or 1 unit
    int evaluations = 200;
};

template <typename Format>
struct March
{
    Outcome outcome = Outcome::Limit;
    int evaluations = 0;
    int index = 0;                   ///< of the last evaluation
    typename Format::Coordinate t{}; ///< the way gone, the last distance included
};

/// A ray that has gone farther misses: 8 units, or with a frame scale 8 scaled units.
template <typename Format>
inline constexpr
    typename Format::Coordinate farthest = power_of_two<Format>(Format::fraction_bits + 3);

/// origin + direction * t, where t has `scale` more fraction bits.
template <typename Format>
[[nodiscard]] constexpr Point<Format> point_at(const Point<Format>& origin,
                                               const Direction& direction,
                                               typename Format::Coordinate t, int scale) noexcept
{
    using Wide = typename Format::WideInteger;
    return origin + map(direction, [&](std::int64_t component) {
               return static_cast<typename Format::Coordinate>((Wide(t) * Wide(component)) >>
                                                               (direction_bits + scale));
           });
}

template <typename Format>
[[nodiscard]] constexpr March<Format> march(const Point<Format>& origin, const Direction& direction,
                                            const Arithmetic& with, Limits limits) noexcept
{
    using Coordinate = typename Format::Coordinate;
    March<Format> ray;
    Coordinate epsilon{1};
    while (ray.evaluations < limits.evaluations) {
        const auto [distance, index] =
            estimate<Format>(point_at<Format>(origin, direction, ray.t, with.scale), with);
        if (ray.evaluations == 0)
            epsilon = std::max(epsilon, Coordinate(distance >> limits.epsilon_shift));
        ++ray.evaluations;
        ray.index = index;
        ray.t += distance;
        if (distance <= epsilon) {
            ray.outcome = Outcome::Hit;
            break;
        }
        if (ray.t > farthest<Format>) {
            ray.outcome = Outcome::Miss;
            break;
        }
    }
    return ray;
}

} // namespace raymarch::engine::mandelbulb
