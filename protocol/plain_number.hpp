// SPDX-License-Identifier: MIT
/// @file
/// The short way of most numbers of most frames: `-0.123` to a code in 64-bit arithmetic, without a
/// branch for each digit. Written for speed and inlined where frames are read; what it does not
/// take, quantizer.hpp reads, and the tests hold the two together.
#pragma once

#include "protocol/round_code.hpp"

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string_view>

namespace raymarch::protocol
{
namespace detail
{

inline constexpr std::array<std::uint64_t, 9> powers_of_ten = {
    1, 10, 100, 1'000, 10'000, 100'000, 1'000'000, 10'000'000, 100'000'000};

/// The upper half of a product of 128 bits, from products of 32 by 32.
constexpr std::uint64_t multiply_high(std::uint64_t a, std::uint64_t b) noexcept
{
    const auto low = [](std::uint64_t value) { return value & UINT32_MAX; };
    const std::uint64_t inner = (a >> 32) * low(b) + (low(a) * low(b) >> 32);
    const std::uint64_t outer = low(a) * (b >> 32) + low(inner);
    return (a >> 32) * (b >> 32) + (inner >> 32) + (outer >> 32);
}

/// floor(2^64 / powers_of_ten[digits]), from one digit on: none of these powers divides 2^64.
inline constexpr std::array<std::uint64_t, 9> reciprocals = {0,
                                                             UINT64_MAX / powers_of_ten[1],
                                                             UINT64_MAX / powers_of_ten[2],
                                                             UINT64_MAX / powers_of_ten[3],
                                                             UINT64_MAX / powers_of_ten[4],
                                                             UINT64_MAX / powers_of_ten[5],
                                                             UINT64_MAX / powers_of_ten[6],
                                                             UINT64_MAX / powers_of_ten[7],
                                                             UINT64_MAX / powers_of_ten[8]};

/// value / powers_of_ten[digits] without a division, which the board's processor has none of: its
/// library takes some 170 instructions for one. The upper half of the product is the quotient or
/// one less, since `value` is below 2^64 and a reciprocal falls short of 2^64 / power by less
/// than 1.
inline std::uint64_t multiply_by_reciprocal(std::uint64_t value, std::size_t digits) noexcept
{
    if (digits == 0)
        return value;
    const std::uint64_t quotient = multiply_high(value, reciprocals[digits]);
    const std::uint64_t rest = value - quotient * powers_of_ten[digits];
    return quotient + (rest >= powers_of_ten[digits] ? 1 : 0);
}

/// The same, in the quickest way that the processor has. On one of 64 bits that is a division by
/// constants: those are multiplications, several times as fast as a division by a number that is
/// not known before.
inline std::uint64_t divide_by_power(std::uint64_t value, std::size_t digits) noexcept
{
    if constexpr (sizeof(void*) < sizeof value)
        return multiply_by_reciprocal(value, digits);
    switch (digits) {
    case 0:
        return value;
    case 1:
        return value / powers_of_ten[1];
    case 2:
        return value / powers_of_ten[2];
    case 3:
        return value / powers_of_ten[3];
    case 4:
        return value / powers_of_ten[4];
    case 5:
        return value / powers_of_ten[5];
    case 6:
        return value / powers_of_ten[6];
    default:
        return value / powers_of_ten[digits];
    }
}

/// A run of digits: how many, and the number that they are.
struct Digits
{
    std::size_t count;
    std::uint64_t value;
};

/// Digit by digit: fewer instructions than the way below where each word of it takes two registers.
inline Digits digits_one_by_one(const char* bytes) noexcept
{
    std::uint32_t value = 0;
    std::size_t count = 0;
    for (; count < 8 && is_digit(bytes[count]); ++count)
        value = value * 10 + static_cast<std::uint32_t>(bytes[count] - '0');
    return {count, value};
}

/// The digits among the eight bytes at `bytes`, up to the first that is none, without a branch for
/// each: the bytes are moved until the last digit stands at the top, and neighbours are joined,
/// first to pairs, then to fours, then to all eight.
inline Digits digits_of_eight(const char* bytes) noexcept
{
    if constexpr (sizeof(void*) < sizeof(std::uint64_t))
        return digits_one_by_one(bytes);
    std::uint64_t block = 0;
    std::memcpy(&block, bytes, sizeof block);
    if constexpr (std::endian::native == std::endian::big)
        block = __builtin_bswap64(block); // the first byte is to be the lowest
    block ^= 0x3030'3030'3030'3030;       // digits are now 0 to 9, all other bytes more
    const std::uint64_t others =
        (block | (block + 0x7676'7676'7676'7676)) & 0x8080'8080'8080'8080;   // exact to the first
    const auto bits = static_cast<unsigned>(std::countr_zero(others)) & ~7U; // 64 without others
    if (bits == 0)
        return {0, 0};
    block <<= 64 - bits;
    block = (block * 10 + (block >> 8)) & 0x00FF'00FF'00FF'00FF;
    block = (block * 100 + (block >> 16)) & 0x0000'FFFF'0000'FFFF;
    block = (block * 10'000 + (block >> 32)) & 0xFFFF'FFFF;
    return {bits / 8, block};
}

} // namespace detail

/// The code of a plain number at the front of `text`: 1 to 4 digits, a point, at most 7 digits, in
/// range, and enough bytes behind it to be read eight at a time. Returns how many characters it
/// has, or 0 for any other text, faulty or not: `quantize` reads all there are, and tells the
/// faults apart.
[[nodiscard]] inline std::size_t quantize_plain(const Parameter& parameter, std::string_view text,
                                                std::int64_t& code) noexcept
{
    // So many bytes are looked at, never more.
    constexpr std::size_t most_integer_digits = 4;
    if (text.size() < 1 + most_integer_digits + 1 + 8)
        return 0;
    const bool negative = text[0] == '-';
    std::size_t at = negative || text[0] == '+' ? 1 : 0;
    const std::size_t integer_begin = at;
    std::uint64_t significand = 0;
    for (; at < integer_begin + most_integer_digits && detail::is_digit(text[at]); ++at)
        significand = significand * 10 + static_cast<std::uint64_t>(text[at] - '0');
    if (at == integer_begin || text[at] != '.')
        return 0;
    const detail::Digits fraction = detail::digits_of_eight(text.data() + ++at);
    const unsigned bits = parameter.format.fraction_bits + 1U;
    significand = significand * detail::powers_of_ten[fraction.count] + fraction.value;
    if (fraction.count == 8 || bits >= 64 || significand >> (64 - bits) != 0)
        return 0;

    const std::uint64_t shifted = significand << bits;
    const std::uint64_t floor = detail::divide_by_power(shifted, fraction.count);
    const bool inexact = floor * detail::powers_of_ten[fraction.count] != shifted;
    if (check_and_round(parameter, negative, {.floor = floor, .inexact = inexact}, code) ==
        Fits::No)
        return 0;
    return at + fraction.count;
}

} // namespace raymarch::protocol
