// SPDX-License-Identifier: MIT
#include "engine/sphere/root.hpp"

namespace raymarch::engine::sphere
{
namespace
{

constexpr int significant_bits = 53;

/// v >> shift and v << shift, for 0 < shift < 64.
constexpr Wide shifted_down(Wide v, int shift) noexcept
{
    return {v.high >> shift, v.low >> shift | v.high << (64 - shift)};
}
constexpr Wide shifted_up(Wide v, int shift) noexcept
{
    return {v.high << shift | v.low >> (64 - shift), v.low << shift};
}

/// To the nearest number of 53 significant bits, a tie to the even one.
Wide to_significant_bits(Wide v) noexcept
{
    const int surplus = bit_width(v) - significant_bits;
    if (surplus <= 0)
        return v;
    const Wide cut = shifted_down(v, surplus);
    const std::uint64_t rest = v.low & ((std::uint64_t{1} << surplus) - 1);
    const std::uint64_t tie = std::uint64_t{1} << (surplus - 1);
    const bool up = rest > tie || (rest == tie && (cut.low & 1) != 0);
    return shifted_up({0, cut.low + (up ? 1U : 0U)}, surplus);
}

} // namespace

std::uint64_t floor_root(Wide v) noexcept
{
    std::uint64_t root = 0;
    for (int bit = (bit_width(v) + 1) / 2 - 1; bit >= 0; --bit) {
        const std::uint64_t candidate = root | std::uint64_t{1} << bit;
        if (!(v - unsigned_product(candidate, candidate)).is_negative())
            root = candidate;
    }
    return root;
}

std::uint64_t rounded_root(Wide v) noexcept
{
    const Wide rounded = to_significant_bits(v);
    const std::uint64_t root = floor_root(rounded);

    // With 2^e <= root < 2^(e+1) the numbers of 53 bits around it are 2^(e-52) apart, so the root
    // becomes n = root + 1 when it lies at most half of that, h, below n:
    //     rounded >= (n - h)^2   or   n^2 - rounded <= 2 n h - h^2.
    // The left side is an integer and 2 n h = n / 2^(52-e), so floor(root / 2^(52-e)) on the right
    // decides the same. Below e = 26 it is 0, and the left side is never below 1.
    const std::uint64_t next = root + 1;
    const std::uint64_t missing = (unsigned_product(next, next) - rounded).low;
    const int e = static_cast<int>(std::bit_width(root)) - 1;
    return root + (missing <= root >> (significant_bits - 1 - e) ? 1U : 0U);
}

} // namespace raymarch::engine::sphere
