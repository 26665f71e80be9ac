// SPDX-License-Identifier: MIT
/// @file
/// TABLE: how the bytes of eight lanes of 16 bits move together, for each choice of lanes.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace raymarch::engine::fractal
{

struct alignas(16) LaneOrder : std::array<std::uint8_t, 16>
{};

/// Row b: the bytes of the lanes that have a bit in b, from the lowest; then whatever.
inline constexpr auto compaction_table = [] {
    std::array<LaneOrder, 256> table{};
    for (std::size_t bits = 0; bits < table.size(); ++bits) {
        std::size_t at = 0;
        for (std::size_t lane = 0; lane < 8; ++lane)
            if ((bits >> lane & 1) != 0)
                for (std::size_t byte = 0; byte < 2; ++byte)
                    table[bits][at++] = static_cast<std::uint8_t>(2 * lane + byte);
    }
    return table;
}();

} // namespace raymarch::engine::fractal
