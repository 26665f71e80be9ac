// SPDX-License-Identifier: MIT
/// @file
/// TABLE: row `set` lists the lanes 0 to 7: first those whose bits are set in `set`, then the
/// others, each in ascending order.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace raymarch::engine::fast
{

/// If only lanes 0 to 3 are in the set, the first four entries are the order of four lanes.
inline constexpr auto lane_orders = [] {
    std::array<std::array<std::uint8_t, 8>, 256> rows{};
    for (std::size_t set = 0; set < rows.size(); ++set) {
        std::size_t at = 0;
        for (const bool wanted : {true, false})
            for (std::size_t lane = 0; lane < 8; ++lane)
                if (((set >> lane & 1) != 0) == wanted)
                    rows[set][at++] = static_cast<std::uint8_t>(lane);
    }
    return rows;
}();

} // namespace raymarch::engine::fast
