// SPDX-License-Identifier: MIT
/// @file
/// TABLE: 1 / sqrt of the normalised square, which model and kernels share (docs/engine.md, 2).
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace raymarch::engine::marcher::inverse_sqrt_table
{

inline constexpr int index_bits = 12;
inline constexpr int step_bits = 14; ///< bits below the index that interpolate
inline constexpr std::size_t entries = std::size_t{1} << index_bits;
/// round(2^32 / sqrt(2)): what turns the root of n into that of 2n.
inline constexpr std::uint64_t half_root = 3'037'000'500;

/// round(2^30 / sqrt(1/2 + i/8192)), from the exact floor of twice that.
consteval std::uint32_t entry(std::uint32_t i)
{
    // (2^31 / sqrt(1/2 + i/8192))^2 = 2^75 / (4096 + i): 2^63 first, then the 12 bits left.
    const std::uint64_t divisor = entries + i;
    std::uint64_t quotient = (std::uint64_t{1} << 63) / divisor;
    const std::uint64_t rest = (std::uint64_t{1} << 63) % divisor;
    quotient = (quotient << 12) + (rest << 12) / divisor;
    std::uint64_t root = 0; // floor(sqrt(quotient)) = floor(2^31 / sqrt(1/2 + i/8192))
    for (std::uint64_t bit = std::uint64_t{1} << 31; bit != 0; bit >>= 1)
        if ((root + bit) * (root + bit) <= quotient)
            root += bit;
    return static_cast<std::uint32_t>((root + 1) >> 1);
}

/// One entry more than the source's, 1.0, so that the last step has an end.
consteval std::array<std::uint32_t, entries + 1> make_table()
{
    std::array<std::uint32_t, entries + 1> table{};
    for (std::uint32_t i = 0; i <= entries; ++i)
        table[i] = entry(i);
    return table;
}

inline constexpr auto table = make_table();

/// Each entry with what it falls by to the next, so that one access takes both: T[i] in the lower
/// half, T[i] - T[i+1] in the upper.
inline constexpr auto falls = [] {
    std::array<std::uint64_t, entries> pairs{};
    for (std::size_t i = 0; i < entries; ++i)
        pairs[i] = table[i] | std::uint64_t{table[i] - table[i + 1]} << 32;
    return pairs;
}();

} // namespace raymarch::engine::marcher::inverse_sqrt_table
