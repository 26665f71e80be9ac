// SPDX-License-Identifier: MIT
/// @file
/// TABLE: for each set of 8 lanes its members in order, then the others.
#pragma once

#include <array>
#include <cstdint>

namespace raymarch::engine::whitted::fast
{

inline constexpr auto packing_order = [] {
    std::array<std::array<std::uint8_t, 8>, 256> orders{};
    for (unsigned set = 0; set < orders.size(); ++set) {
        std::size_t at = 0;
        for (const bool member : {true, false})
            for (std::uint8_t lane = 0; lane < 8; ++lane)
                if (((set >> lane & 1) != 0) == member)
                    orders[set][at++] = lane;
    }
    return orders;
}();

} // namespace raymarch::engine::whitted::fast
