// SPDX-License-Identifier: MIT
/// @file
/// TABLE: the numbers of the marcher's pipeline (docs/engine.md, "Numbers").
#pragma once

#include "base/fixed.hpp"
#include "engine/vec3.hpp"

#include <cstdint>

namespace raymarch::engine::marcher
{

/// Positions, distances, directions, light: Q8.24; sums wrap, products are floored.
using Coordinate = Q<8, 24>;
/// The exact product of two coordinates.
using Product = Q<16, 48>;
using Point = Vec3<Coordinate>;

/// Any vector whose length does not matter yet: 32-bit integers in units of its own.
using RawVector = Vec3<std::int32_t>;

/// numerator / denominator as a coordinate, to the nearest code; ties do not occur.
[[nodiscard]] consteval Coordinate ratio(std::int64_t numerator, std::int64_t denominator)
{
    const std::int64_t doubled = 2 * numerator * (std::int64_t{1} << Coordinate::fraction_bits);
    return Coordinate::from_raw((doubled + denominator) / (2 * denominator));
}

/// The Q8.24 product: all 64 bits, shifted right arithmetically by 24 (source 000, Fig. 21).
[[nodiscard]] constexpr Coordinate multiply(Coordinate a, Coordinate b) noexcept
{
    return narrow<Coordinate>(a * b);
}

[[nodiscard]] constexpr Coordinate absolute(Coordinate a) noexcept
{
    return a < Coordinate{} ? -a : a;
}

[[nodiscard]] constexpr RawVector raw(const Point& p) noexcept
{
    return map(p, [](Coordinate c) { return c.raw(); });
}

inline constexpr Coordinate surface_distance = ratio(1, 100); ///< SURFACE_DIST
inline constexpr Coordinate max_distance = ratio(20, 1);      ///< MAX_DIST
inline constexpr int max_steps = 100;                         ///< MAX_STEPS
inline constexpr Coordinate normal_step = ratio(1, 100);      ///< h of the four taps

} // namespace raymarch::engine::marcher
