// SPDX-License-Identifier: MIT
/// @file
/// The optional check of a line: `*HH`, the XOR of all bytes before the `*` (as in NMEA 0183).
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>

namespace raymarch::protocol
{

[[nodiscard]] constexpr std::uint8_t xor_of(std::string_view bytes) noexcept
{
    std::uint8_t sum = 0;
    for (const char c : bytes)
        sum = static_cast<std::uint8_t>(sum ^ static_cast<std::uint8_t>(c));
    return sum;
}

inline constexpr std::string_view hex_digits = "0123456789ABCDEF";

/// The value of one hex digit of either case.
[[nodiscard]] constexpr std::optional<std::uint8_t> hex_value(char c) noexcept
{
    if (c >= '0' && c <= '9')
        return static_cast<std::uint8_t>(c - '0');
    if (c >= 'a' && c <= 'f')
        return static_cast<std::uint8_t>(c - 'a' + 10);
    if (c >= 'A' && c <= 'F')
        return static_cast<std::uint8_t>(c - 'A' + 10);
    return std::nullopt;
}

} // namespace raymarch::protocol
