// SPDX-License-Identifier: MIT
/// @file
/// How far the pipeline's numbers may be from the real ones that they stand for, as the frame's N
/// and k have it. docs/engine/mandelbulb.md, "Fast kernels", derives every line.
#pragma once

#include "engine/mandelbulb/iteration.hpp"

#include <cmath>

namespace raymarch::engine::mandelbulb::fast
{

/// Bounds of errors; P = r^(d-1) and Q = r^d of the point in question.
struct Bounds
{
    // One iteration moves a point to at most q * Q + p * P + c beside its place.
    double q;
    double p;
    double c;
    // The radius of a point: relative and absolute.
    double radius_relative;
    double radius_absolute;
    double kept;          ///< relative, of one factor of the approximate multiplier
    double power_floor;   ///< of P, in units of max(1, P)
    double logarithm;     ///< absolute
    double quotient;      ///< relative
    double distance_unit; ///< absolute, of a distance
};

/// The bounds presuppose this.
[[nodiscard]] constexpr bool bounded(const Arithmetic& with) noexcept
{
    return with.steps >= 20 && with.kept_bits >= 20 && with.scale == 0;
}

[[nodiscard]] inline Bounds bounds_of(const Arithmetic& with, int fraction_bits) noexcept
{
    const double n = with.steps;
    const double d = with.power;
    const double unit = std::ldexp(1.0, -fraction_bits);
    const double last_angle = std::ldexp(1.0, 1 - with.steps);
    const double turned = 1.01 * last_angle + std::ldexp(n, -61);
    const double kept = std::ldexp(1.0, 1 - with.kept_bits);
    constexpr double slack = 1.2;
    return {.q = slack * ((2 * d + 2) * turned + 2 * (d - 1) * kept + d * last_angle * last_angle +
                          std::ldexp(n, -60) + std::ldexp(64 * d, -53)),
            .p = slack * n * unit * (10.2 * d + 3 * d * d),
            .c = slack * unit * (6 * n + 32) + std::ldexp(1.0, -48),
            .radius_relative = 1.01 * last_angle * last_angle + std::ldexp(1.0, -50),
            .radius_absolute = 4.1 * n * unit,
            .kept = kept,
            .power_floor = d * unit,
            .logarithm = last_angle + (2 * n + 8) * unit + std::ldexp(1.0, -44),
            .quotient = 2 * last_angle + 4 * n * unit + std::ldexp(1.0, -44),
            .distance_unit = 2 * unit};
}

} // namespace raymarch::engine::mandelbulb::fast
