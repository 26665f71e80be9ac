// SPDX-License-Identifier: MIT
/// @file
/// TABLE: for each set of up to eight lanes, the numbers of the lanes in it, from the lowest on.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace raymarch::engine::marcher
{

inline constexpr auto orders = [] {
    std::array<std::array<std::uint8_t, 8>, 256> rows{};
    for (std::size_t set = 0; set < rows.size(); ++set) {
        std::size_t count = 0;
        for (std::uint8_t lane = 0; lane < 8; ++lane)
            if ((set >> lane & 1) != 0)
                rows[set][count++] = lane;
    }
    return rows;
}();

} // namespace raymarch::engine::marcher
