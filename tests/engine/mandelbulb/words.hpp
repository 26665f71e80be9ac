// SPDX-License-Identifier: MIT
/// @file
/// Hex digits of the vectors as numbers.
#pragma once

#include <cstdint>
#include <string>

namespace raymarch::engine::mandelbulb
{

/// Eighteen digits are 72 bits in two's complement.
template <typename Wide>
Wide wide_word(const std::string& hex)
{
    const auto upper = static_cast<std::int8_t>(std::stoul(hex.substr(0, 2), nullptr, 16));
    return (Wide(upper) << 64) + Wide(std::uint64_t{std::stoull(hex.substr(2), nullptr, 16)});
}

/// Sixteen digits.
inline std::int64_t direction_word(const std::string& hex)
{
    return static_cast<std::int64_t>(std::stoull(hex, nullptr, 16));
}

} // namespace raymarch::engine::mandelbulb
