// SPDX-License-Identifier: MIT
/// @file
/// The derivative of the iteration (source 003, equation 4): dr' = d * r^(d-1) * dr + 1.
#pragma once

#include "engine/mandelbulb/multiplier.hpp"

#include <cstdint>

namespace raymarch::engine::mandelbulb
{

/// mantissa / 2^fraction_bits, never below 1. The fraction shrinks, below zero at last, where the
/// derivative slides.
struct Derivative
{
    std::uint64_t mantissa = std::uint64_t{1} << 32;
    int fraction_bits = 32;
    bool operator==(const Derivative&) const = default;
};

/// The derivative takes one of these forms above Q33.32.
enum class DerivativeForm : std::uint8_t {
    Sliding,   ///< the point moves, and dr keeps its upper 64 bits
    Saturating ///< the source's Q33.32: dr stays at its largest value
};

/// dr' of a point whose r^(d-1) is `power`.
template <typename Format>
[[nodiscard]] constexpr Derivative next_derivative(Derivative dr, typename Format::Coordinate power,
                                                   int d, int kept, DerivativeForm form) noexcept
{
    using Wide = typename Format::WideInteger;
    Wide sum = Wide(d) * Format::product(keep(power, kept), keep(dr.mantissa, kept));
    if (dr.fraction_bits >= 0)
        sum += Wide(1) << dr.fraction_bits;
    if ((sum >> 64) != 0) {
        if (form == DerivativeForm::Saturating)
            return {~std::uint64_t{0}, dr.fraction_bits};
        const int shift = leading_one(sum) - 63;
        sum >>= shift;
        dr.fraction_bits -= shift;
    }
    return {static_cast<std::uint64_t>(sum), dr.fraction_bits};
}

} // namespace raymarch::engine::mandelbulb
