// SPDX-License-Identifier: MIT
/// @file
/// One Mandelbulb iteration core (source 003, Fig. 3): w -> w^d + c in spherical coordinates.
#pragma once

#include "engine/mandelbulb/cordic.hpp"
#include "engine/mandelbulb/derivative.hpp"

#include <cstdint>

namespace raymarch::engine::mandelbulb
{

/// An evaluation of the distance needs this besides the point; it is latched once a frame.
struct Arithmetic
{
    int steps = 32;      ///< N: of CORDIC, BKM and division, 8 to 64
    int kept_bits = 36;  ///< k: of the approximate multiplier, 8 to 64 (all)
    int power = 8;       ///< d: 2 to 16
    int iterations = 25; ///< I: cores that a point passes, 1 to 64
    DerivativeForm derivative = DerivativeForm::Sliding;
    int scale = 0; ///< ts: fraction bits of a distance beyond those of a coordinate, 0 to 60
    bool operator==(const Arithmetic&) const = default;
};

/// The state that travels from core to core.
template <typename Format>
struct Orbit
{
    Point<Format> w{};
    Point<Format> c{};
    typename Format::Coordinate r{}; ///< of w, once a core has seen it
    Derivative dr{};
    int index = 0; ///< kk: how often w has moved
};

enum class Last : bool { No, Yes };

/// Beyond it a point has escaped: 2 for d = 2, 3/2 up to d = 8, then 19/16, so that r^d stays
/// below 64 and the radius above 2^(1/(d-1)).
template <typename Format>
[[nodiscard]] constexpr typename Format::Coordinate escape_radius(int d) noexcept
{
    const int sixteenths = d == 2 ? 32 : d <= 8 ? 24 : 19;
    return typename Format::Coordinate(sixteenths) << (Format::fraction_bits - 4);
}

/// One core; false: the orbit holds, every later core lets it pass. The last core only tests, so
/// that r and dr always belong to the same index.
template <typename Format>
[[nodiscard]] constexpr bool iterate(Orbit<Format>& orbit, const Arithmetic& with,
                                     Last last) noexcept
{
    Spherical<Format> s = to_spherical<Format>(orbit.w, with.steps);
    orbit.r = s.r;
    if (s.r > escape_radius<Format>(with.power) || last == Last::Yes)
        return false;
    const auto [lower, upper] = powers<Format>(s.r, with.power, with.kept_bits);
    orbit.dr =
        next_derivative<Format>(orbit.dr, lower, with.power, with.kept_bits, with.derivative);
    const auto turns = static_cast<Angle>(with.power);
    s = {upper, s.theta * turns, s.phi * turns};
    orbit.w = to_point<Format>(s, with.steps) + orbit.c;
    ++orbit.index;
    return true;
}

} // namespace raymarch::engine::mandelbulb
