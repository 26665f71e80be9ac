// SPDX-License-Identifier: MIT
/// @file
/// The 128-bit signed numbers of the ray-sphere unit, as two limbs: the discriminant is the one
/// value of the pipeline that leaves 64 bits (71 in the hardware, 79 without its 16-bit
/// coordinates).
#pragma once

#include <bit>
#include <cstdint>

namespace raymarch::engine::sphere
{

/// Two's complement. Results of more than 128 bits wrap; none of this folder's do.
struct Wide
{
    std::uint64_t high = 0;
    std::uint64_t low = 0;

    bool operator==(const Wide&) const = default;

    [[nodiscard]] constexpr bool is_negative() const noexcept { return high >> 63 != 0; }

    [[nodiscard]] friend constexpr Wide operator-(Wide a, Wide b) noexcept
    {
        return {a.high - b.high - (a.low < b.low ? 1U : 0U), a.low - b.low};
    }
};

/// a * b, both unsigned.
[[nodiscard]] constexpr Wide unsigned_product(std::uint64_t a, std::uint64_t b) noexcept
{
    constexpr std::uint64_t half = 0xFFFF'FFFF;
    const std::uint64_t low = (a & half) * (b & half);
    const std::uint64_t cross = (a >> 32) * (b & half) + (low >> 32); // at most 2^64 - 2^32
    const std::uint64_t other = (a & half) * (b >> 32) + (cross & half);
    return {(a >> 32) * (b >> 32) + (cross >> 32) + (other >> 32), other << 32 | (low & half)};
}

/// a * b, exact.
[[nodiscard]] constexpr Wide product(std::int64_t a, std::int64_t b) noexcept
{
    Wide result = unsigned_product(static_cast<std::uint64_t>(a), static_cast<std::uint64_t>(b));
    // A negative factor counts as 2^64 more than it is.
    result.high -= a < 0 ? static_cast<std::uint64_t>(b) : 0;
    result.high -= b < 0 ? static_cast<std::uint64_t>(a) : 0;
    return result;
}

/// How many bits a number that is not negative has; 0 has none.
[[nodiscard]] constexpr int bit_width(Wide v) noexcept
{
    return static_cast<int>(v.high != 0 ? 64 + std::bit_width(v.high) : std::bit_width(v.low));
}

} // namespace raymarch::engine::sphere
