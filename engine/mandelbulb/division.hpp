// SPDX-License-Identifier: MIT
/// @file
/// Division by CORDIC in linear mode (source 003, §IV.E): both numbers are normalised before it,
/// the quotient is moved back behind it.
#pragma once

#include "engine/mandelbulb/cordic.hpp"
#include "engine/mandelbulb/derivative.hpp"

#include <algorithm>

namespace raymarch::engine::mandelbulb
{

/// With a frame scale a quotient of 16 and more is this one: far enough for every ray to end.
template <typename Format>
inline constexpr
    typename Format::Coordinate far_away = power_of_two<Format>(Format::fraction_bits + 4);

/// numerator / derivative, with `scale` more fraction bits than a coordinate; numerator > 0.
template <typename Format>
[[nodiscard]] constexpr typename Format::Coordinate
divide(typename Format::Coordinate numerator, Derivative derivative, int scale, int steps) noexcept
{
    using Coordinate = typename Format::Coordinate;
    constexpr int unit = Format::fraction_bits;
    const auto normalised = [](auto a, int leading) {
        return leading >= unit ? Coordinate(a >> (leading - unit))
                               : Coordinate(a) << (unit - leading);
    };
    const int leading_numerator = leading_one(numerator);
    const int leading_derivative = leading_one(derivative.mantissa);
    Coordinate rest = normalised(numerator, leading_numerator);
    const Coordinate divisor = normalised(derivative.mantissa, leading_derivative);
    Coordinate quotient{0}; // 1/2 to 2
    for (int i = 0; i < steps; ++i) {
        const Coordinate sign = sign_of(rest);
        rest -= ((divisor >> i) ^ sign) - sign;
        quotient += ((power_of_two<Format>(unit) >> i) ^ sign) - sign;
    }

    const int shift = leading_numerator - leading_derivative + derivative.fraction_bits - unit;
    const int scaled_shift = shift + scale;
    if (scaled_shift < 0)
        return quotient >> std::min(-scaled_shift, unit + 1);
    if (scale > 0 && scaled_shift > 3)
        return far_away<Format>;
    return quotient << scaled_shift;
}

} // namespace raymarch::engine::mandelbulb
