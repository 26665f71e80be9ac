// SPDX-License-Identifier: MIT
/// @file
/// The 3D CORDIC core (source 003, §IV.C, Fig. 5, 6): Cartesian to polar and back by shifts and
/// sums, twice each for three dimensions. The gain is removed behind every stage.
#pragma once

#include "engine/mandelbulb/formats.hpp"
#include "engine/mandelbulb/tables.hpp"

#include <cstddef>
#include <cstdint>

namespace raymarch::engine::mandelbulb
{

/// 2^64 is one turn, so that wrapping is right.
using Angle = std::uint64_t;

template <typename Format>
struct Polar
{
    typename Format::Coordinate magnitude{};
    Angle angle = 0;
};

template <typename Format>
struct Cartesian
{
    typename Format::Coordinate x{};
    typename Format::Coordinate y{};
};

/// All ones for a negative number, else 0. A number xor a sign, minus the sign, is negated where
/// the sign is set, so that no loop below has a branch that the machine could guess wrong; the sign
/// is subtracted first, from the other operand, so that it waits for nothing.
template <typename T>
[[nodiscard]] constexpr T sign_of(T a) noexcept
{
    return a >> static_cast<int>(8 * sizeof(T) - 1);
}

/// CTP, vectoring: turns (x, y) onto the x axis.
template <typename Format>
[[nodiscard]] constexpr Polar<Format> to_polar(typename Format::Coordinate x,
                                               typename Format::Coordinate y, int steps) noexcept
{
    using Coordinate = typename Format::Coordinate;
    Angle angle = 0;
    if (x < 0) {
        x = -x;
        y = -y;
        angle = Angle{1} << 63;
    }
    for (int i = 0; i < steps; ++i) {
        const Coordinate sign = sign_of(y);
        const Coordinate across = x >> i;
        const Coordinate along = y >> i;
        const auto sign_word = static_cast<std::uint64_t>(sign);
        x = (x - sign) + (along ^ sign);
        y = (y + sign) - (across ^ sign);
        angle = (angle - sign_word) + (angles[static_cast<std::size_t>(i)] ^ sign_word);
    }
    return {Format::scaled(x, gain_of(steps)), angle};
}

/// CTC, rotation: (r cos angle, r sin angle). r may be negative.
template <typename Format>
[[nodiscard]] constexpr Cartesian<Format> to_cartesian(typename Format::Coordinate r, Angle angle,
                                                       int steps) noexcept
{
    using Coordinate = typename Format::Coordinate;
    Coordinate x = Format::scaled(r, gain_of(steps));
    Coordinate y{0};
    if (((angle ^ (angle << 1)) >> 63) != 0) { // in the half plane that the steps do not reach
        angle ^= Angle{1} << 63;
        x = -x;
    }
    for (int i = 0; i < steps; ++i) {
        const std::int64_t sign_word = sign_of(static_cast<std::int64_t>(angle));
        const auto turned = static_cast<Angle>(sign_word);
        const Coordinate sign{sign_word};
        const Coordinate across = x >> i;
        const Coordinate along = y >> i;
        x = (x + sign) - (along ^ sign);
        y = (y - sign) + (across ^ sign);
        angle = (angle + turned) - (angles[static_cast<std::size_t>(i)] ^ turned);
    }
    return {x, y};
}

/// A point as radius, angle from the z axis (0 to half a turn), and angle about it.
template <typename Format>
struct Spherical
{
    typename Format::Coordinate r{};
    Angle theta = 0;
    Angle phi = 0;
};

template <typename Format>
[[nodiscard]] constexpr Spherical<Format> to_spherical(const Point<Format>& p, int steps) noexcept
{
    const auto [rho, phi] = to_polar<Format>(p.x, p.y, steps);
    const auto [r, theta] = to_polar<Format>(p.z, rho, steps);
    return {r, theta, phi};
}

template <typename Format>
[[nodiscard]] constexpr Point<Format> to_point(const Spherical<Format>& s, int steps) noexcept
{
    const auto [z, rho] = to_cartesian<Format>(s.r, s.theta, steps);
    const auto [x, y] = to_cartesian<Format>(rho, s.phi, steps);
    return {x, y, z};
}

} // namespace raymarch::engine::mandelbulb
