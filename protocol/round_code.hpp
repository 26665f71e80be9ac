// SPDX-License-Identifier: MIT
/// @file
/// Checks the range of a number and rounds it to the code of a parameter.
#pragma once

#include "protocol/decimal.hpp"
#include "protocol/parameters.hpp"

#include <algorithm>
#include <cstdint>

namespace raymarch::protocol
{

enum class Fits : std::uint8_t { Yes, No };

/// `doubled` is the magnitude in half codes. It has one bit more than the format, so a tie can be
/// seen. A valid number never takes one of the branches, so the processor predicts them well.
inline Fits check_and_round(const Parameter& parameter, bool negative, Scaled doubled,
                            std::int64_t& code) noexcept
{
    const Limits& limits = negative ? parameter.negative : parameter.positive;
    const std::uint64_t inexact = doubled.inexact ? 1 : 0;
    if (doubled.floor < limits.least || doubled.floor >= limits.first_above - inexact)
        return Fits::No;

    const std::uint64_t floor = doubled.floor >> 1;
    const std::uint64_t up = doubled.floor & (inexact | floor) & 1;
    const auto magnitude = static_cast<std::int64_t>(floor + up);
    const std::int64_t held = std::min(magnitude, parameter.largest_code);
    code = negative ? -magnitude : held;
    return Fits::Yes;
}

} // namespace raymarch::protocol
