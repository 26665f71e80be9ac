// SPDX-License-Identifier: MIT
/// @file
/// The approximate multiplier (source 003, §IV.D, Fig. 7) and the powers made with it.
#pragma once

#include "engine/mandelbulb/formats.hpp"

namespace raymarch::engine::mandelbulb
{

/// From here on nothing is cleared.
inline constexpr int all_bits = 64;

/// Clears all but the `kept` bits from the leading one on; a >= 0.
template <typename T>
[[nodiscard]] constexpr T keep(T a, int kept) noexcept
{
    if (kept >= all_bits || a == 0)
        return a;
    const int cleared = leading_one(a) + 1 - kept;
    return cleared <= 0 ? a : (a >> cleared) << cleared;
}

/// a * b from their upper bits; a, b >= 0.
template <typename Format>
[[nodiscard]] constexpr typename Format::Coordinate
approximate_product(typename Format::Coordinate a, typename Format::Coordinate b, int kept) noexcept
{
    return Format::product(keep(a, kept), keep(b, kept));
}

/// r^(d-1), which the derivative takes, and r^d, which the point takes.
template <typename Format>
struct Powers
{
    typename Format::Coordinate lower{};
    typename Format::Coordinate upper{};
};

/// Binary powering from the right; d is 2 to 16.
template <typename Format>
[[nodiscard]] constexpr Powers<Format> powers(typename Format::Coordinate r, int d,
                                              int kept) noexcept
{
    using Coordinate = typename Format::Coordinate;
    Coordinate lower{0};
    bool empty = true;
    Coordinate square = r;
    for (int n = d - 1; n != 0;) {
        if (n % 2 != 0) {
            lower = empty ? square : approximate_product<Format>(lower, square, kept);
            empty = false;
        }
        n /= 2;
        if (n != 0)
            square = approximate_product<Format>(square, square, kept);
    }
    return {lower, approximate_product<Format>(lower, r, kept)};
}

} // namespace raymarch::engine::mandelbulb
