// SPDX-License-Identifier: MIT
/// @file
/// The distance estimator (source 003, equation 5, Fig. 4): half r ln r / dr of the last point.
#pragma once

#include "engine/mandelbulb/division.hpp"
#include "engine/mandelbulb/iteration.hpp"
#include "engine/mandelbulb/logarithm.hpp"

namespace raymarch::engine::mandelbulb
{

template <typename Format>
struct Estimate
{
    typename Format::Coordinate distance{}; ///< with Arithmetic::scale more fraction bits
    int index = 0;                          ///< of the last iteration
};

/// From what the cores left: 0 where the point has not gone beyond 1.
template <typename Format>
[[nodiscard]] constexpr typename Format::Coordinate
distance_of(typename Format::Coordinate r, Derivative dr, const Arithmetic& with) noexcept
{
    using Coordinate = typename Format::Coordinate;
    if (r <= power_of_two<Format>(Format::fraction_bits))
        return Coordinate{0};
    const Coordinate l = logarithm<Format>(r, with.steps);
    if (l <= 0)
        return Coordinate{0};
    const Coordinate half = Format::half_product(keep(l, with.kept_bits), keep(r, with.kept_bits));
    if (half == 0)
        return Coordinate{0};
    return divide<Format>(half, dr, with.scale, with.steps);
}

/// All cores, from w = c = the point: one step after zero.
template <typename Format>
[[nodiscard]] constexpr Orbit<Format> orbit_of(const Point<Format>& point,
                                               const Arithmetic& with) noexcept
{
    Orbit<Format> orbit{.w = point, .c = point};
    int core = 1;
    while (iterate(orbit, with, core == with.iterations ? Last::Yes : Last::No))
        ++core;
    return orbit;
}

template <typename Format>
[[nodiscard]] constexpr Estimate<Format> estimate(const Point<Format>& point,
                                                  const Arithmetic& with) noexcept
{
    const Orbit<Format> orbit = orbit_of<Format>(point, with);
    return {distance_of<Format>(orbit.r, orbit.dr, with), orbit.index};
}

} // namespace raymarch::engine::mandelbulb
