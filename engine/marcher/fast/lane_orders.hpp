// SPDX-License-Identifier: MIT
/// @file
/// TABLE: for each set of a vector's lanes, all lanes: those in it first, then the others.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace raymarch::engine::marcher
{

template <std::size_t lanes>
using LaneOrders = std::array<std::array<std::uint8_t, lanes>, std::size_t{1} << lanes>;

template <std::size_t lanes>
constexpr LaneOrders<lanes> make_lane_orders() noexcept
{
    static_assert(lanes <= 8);
    LaneOrders<lanes> rows{};
    for (std::size_t set = 0; set < rows.size(); ++set) {
        std::size_t at = 0;
        for (const bool wanted : {true, false})
            for (std::size_t lane = 0; lane < lanes; ++lane)
                if (((set >> lane & 1) != 0) == wanted)
                    rows[set][at++] = static_cast<std::uint8_t>(lane);
    }
    return rows;
}

template <std::size_t lanes>
inline constexpr LaneOrders<lanes> lane_orders = make_lane_orders<lanes>();

} // namespace raymarch::engine::marcher
