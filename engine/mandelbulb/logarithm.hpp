// SPDX-License-Identifier: MIT
/// @file
/// The natural logarithm by BKM in L-mode (source 003, §IV.E).
#pragma once

#include "engine/mandelbulb/formats.hpp"
#include "engine/mandelbulb/tables.hpp"

#include <cstddef>

namespace raymarch::engine::mandelbulb
{

/// ln r; r > 0.
template <typename Format>
[[nodiscard]] constexpr typename Format::Coordinate logarithm(typename Format::Coordinate r,
                                                              int steps) noexcept
{
    using Coordinate = typename Format::Coordinate;
    constexpr auto table = logarithms_in<Format::fraction_bits>();

    const int exponent = leading_one(r) - Format::fraction_bits;
    const Coordinate mantissa = exponent >= 0 ? r >> exponent : r << -exponent; // 1 to 2
    Coordinate product = power_of_two<Format>(Format::fraction_bits);
    Coordinate sum{0};
    for (int i = 0; i < steps; ++i) { // the mantissa, as a product of 1 + 2^-i
        const Coordinate next = product + (product >> i);
        if (next <= mantissa) {
            product = next;
            sum += Coordinate(table[static_cast<std::size_t>(i)]);
        }
    }
    return sum + Coordinate(exponent) * Coordinate(table[0]);
}

} // namespace raymarch::engine::mandelbulb
