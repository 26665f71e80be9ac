// SPDX-License-Identifier: MIT
/// @file
/// The fast path of the quantizer: numbers as hosts write them, `-0.123`, to codes, by one
/// multiplication in place of a division. quantizer.hpp reads what this path leaves, and the tests
/// hold the two together.
#pragma once

#include "protocol/round_code.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace raymarch::protocol
{
namespace detail
{

/// The digits of a plain number, those behind its point, and the fraction bits of half a code.
inline constexpr unsigned max_plain_digits = 9;
inline constexpr unsigned max_plain_decimals = 7;
inline constexpr unsigned max_plain_bits = 27;

/// For each number of decimals d the least s, from 32 on, with 10^max_plain_digits * 10^d <= 2^s.
inline constexpr std::array<std::uint8_t, max_plain_decimals + 1> plain_shifts = {32, 34, 37, 40,
                                                                                  44, 47, 50, 54};

/// floor(2^exponent / divisor), for a quotient below 2^64 and a divisor below 2^63.
constexpr std::uint64_t power_of_two_divided(unsigned exponent, std::uint64_t divisor)
{
    std::uint64_t quotient = 0;
    std::uint64_t rest = 1;
    for (; exponent > 0; --exponent) {
        rest *= 2;
        quotient *= 2;
        if (rest >= divisor) {
            rest -= divisor;
            ++quotient;
        }
    }
    return quotient;
}

/// plain_factors[bits][d] = floor(2^(bits + s) / 10^d) + 1, where s = plain_shifts[d].
///
/// So value * 2^bits / 10^d is value * factor / 2^s, which is too large by value / 2^s at most.
/// That is less than 10^-d, the distance from a fraction of 10^d to the next integer above it: the
/// integer parts are the same. It also tells whether the division is exact. Then the lower s bits
/// of value * factor are at most `value`; if it is not, they are 2^s / 10^d at least, which is more
/// than `value`.
inline constexpr auto plain_factors = [] {
    std::array<std::array<std::uint64_t, max_plain_decimals + 1>, max_plain_bits + 1> factors{};
    for (unsigned bits = 0; bits <= max_plain_bits; ++bits) {
        std::uint64_t power = 1;
        for (unsigned decimals = 0; decimals <= max_plain_decimals; ++decimals, power *= 10)
            factors[bits][decimals] =
                power_of_two_divided(bits + plain_shifts[decimals], power) + 1;
    }
    return factors;
}();

/// Reads digits from `at` on, as the lower digits of `value`; returns where they end.
inline const char* read_digits(const char* at, const char* end, std::uint32_t& value) noexcept
{
    for (; at != end; ++at) {
        const auto digit = static_cast<std::uint32_t>(*at) - '0';
        if (digit > 9)
            break;
        value = value * 10 + digit;
    }
    return at;
}

/// value * 2^bits / 10^decimals, for a value of at most max_plain_digits digits.
inline Scaled scale_plain(std::uint32_t value, unsigned bits, unsigned decimals) noexcept
{
    // In two products of 32 by 32 bits, which the board has an instruction for.
    const std::uint64_t factor = plain_factors[bits][decimals];
    const std::uint64_t low = std::uint64_t{value} * static_cast<std::uint32_t>(factor);
    const std::uint64_t high = std::uint64_t{value} * (factor >> 32) + (low >> 32);
    const unsigned shift = plain_shifts[decimals] - 32U;
    const auto below = static_cast<std::uint32_t>(high) & ((std::uint32_t{1} << shift) - 1);
    return {.floor = high >> shift,
            .inexact = below != 0 || static_cast<std::uint32_t>(low) > value};
}

} // namespace detail

/// The code of a number at the front of `text` that has at most 9 digits, 7 of them behind a
/// point, no exponent, and is in range. Returns how many characters the number has, or 0 for any
/// other text, faulty or not.
[[nodiscard]] inline std::size_t quantize_plain(const Parameter& parameter, std::string_view text,
                                                std::int64_t& code) noexcept
{
    const char* at = text.data();
    const char* const end = at + text.size();
    const bool negative = at != end && *at == '-';
    if (negative || (at != end && *at == '+'))
        ++at;

    std::uint32_t value = 0; // wraps around where there are too many digits
    const char* const digits = at;
    at = detail::read_digits(at, end, value);
    auto count = static_cast<std::size_t>(at - digits);
    std::size_t decimals = 0;
    if (at != end && *at == '.') {
        const char* const fraction = at + 1;
        at = detail::read_digits(fraction, end, value);
        decimals = static_cast<std::size_t>(at - fraction);
        count += decimals;
    }
    const unsigned bits = parameter.format.fraction_bits + 1U;
    if (count == 0 || count > detail::max_plain_digits || decimals > detail::max_plain_decimals ||
        bits > detail::max_plain_bits)
        return 0;
    const Scaled doubled = detail::scale_plain(value, bits, static_cast<unsigned>(decimals));
    if (doubled.floor > UINT32_MAX)
        return 0;
    // Now that it is known to be short, the board rounds it in half as many instructions.
    const auto magnitude = static_cast<std::uint32_t>(doubled.floor);
    if (check_and_round(parameter, negative, {magnitude, doubled.inexact}, code) == Fits::No)
        return 0;
    return static_cast<std::size_t>(at - text.data());
}

} // namespace raymarch::protocol
