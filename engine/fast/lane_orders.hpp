// SPDX-License-Identifier: MIT
/// @file
/// TABLE: for each set of eight lanes, all eight: those in it first, then the others.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace raymarch::engine::fast
{

/// The first four of a row are the order of four lanes, where only those are in the set.
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
