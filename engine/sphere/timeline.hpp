// SPDX-License-Identifier: MIT
/// @file
/// The hardware's clock: how many edges each outcome of a pixel takes, and whether the shading
/// divider is in time.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace raymarch::engine::sphere
{

/// How the core left a pixel.
enum class Outcome : std::uint8_t {
    Missed,      ///< the line misses the sphere
    Behind,      ///< the sphere lies behind the camera; the hardware as it is has no such outcome
    LitClear,    ///< the line to the light misses the sphere
    LitRejected, ///< it meets the sphere, but not on the way to the light
    Shadowed,
};

struct OutcomeRow
{
    Outcome outcome;
    std::uint16_t ready;  ///< edges from the core's enable to its ready
    std::uint16_t period; ///< edges from one enable to the next
    std::uint8_t rays;    ///< runs of the ray-sphere unit
    bool lit;             ///< the value comes from the divider
};

/// A run of the unit ends at its count 1000, 2500 or 3500; the core adds 4 edges to one run, 105 to
/// two with the divider and 9 without. The frame buffer takes the value at the next edge of its
/// phase 1, one in four, and enables the core two edges later.
inline constexpr std::array outcomes = {
    OutcomeRow{Outcome::Missed, 1004, 1008, 1, false},
    OutcomeRow{Outcome::Behind, 2504, 2508, 1, false},
    OutcomeRow{Outcome::LitClear, 4605, 4608, 2, true},
    OutcomeRow{Outcome::LitRejected, 6105, 6108, 2, true},
    OutcomeRow{Outcome::Shadowed, 7009, 7012, 2, false},
};

[[nodiscard]] constexpr const OutcomeRow& row_of(Outcome outcome) noexcept
{
    return outcomes[static_cast<std::size_t>(outcome)];
}

/// The outcome that takes so many edges.
[[nodiscard]] constexpr const OutcomeRow& row_of_period(std::uint32_t period) noexcept
{
    for (const OutcomeRow& row : outcomes)
        if (row.period == period)
            return row;
    return outcomes[0];
}

/// The core's first enable; edges count from 1 at power-up.
inline constexpr std::uint64_t first_enable = 4;

/// True if the quotient of a lit pixel that was enabled at `enable` is loaded before it is read.
/// The divider's operands are set 64 edges before, but it loads only at edges 64, 192, 320, ….
[[nodiscard]] constexpr bool divider_in_time(std::uint64_t enable, const OutcomeRow& row) noexcept
{
    const std::uint64_t set = (enable + row.ready - 64) % 128;
    return set >= 1 && set <= 64;
}

} // namespace raymarch::engine::sphere
