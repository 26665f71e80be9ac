// SPDX-License-Identifier: MIT
/// @file
/// Every entry of the tables, against series in 256 bits: an entry is right when the exact value
/// lies within half a unit of it.
#include "engine/mandelbulb/tables.hpp"
#include "tests/engine/mandelbulb/big_fixed.hpp"

#include <gtest/gtest.h>

namespace raymarch::engine::mandelbulb
{
namespace
{

const BigFixed zero{0};
const BigFixed one{1};

/// atan(x) from its odd powers, each `next` of the one before.
template <typename Next>
BigFixed arc_tangent(BigFixed x, Next next)
{
    BigFixed sum = zero;
    for (std::uint32_t k = 0; x != zero; ++k, x = next(x))
        sum = k % 2 == 0 ? sum + x / (2 * k + 1) : sum - x / (2 * k + 1);
    return sum;
}

BigFixed reciprocal_arc_tangent(std::uint32_t n)
{
    return arc_tangent(one / n, [&](const BigFixed& x) { return x / n / n; });
}

BigFixed pi()
{
    return reciprocal_arc_tangent(5) * 16 - reciprocal_arc_tangent(239) * 4;
}

/// ln(1 + 2^-i).
BigFixed logarithm_of(int i)
{
    BigFixed sum = zero;
    const int step = i == 0 ? 1 : i; // ln 2 = the sum of 1 / (k 2^k)
    BigFixed power = one >> step;
    for (std::uint32_t k = 1; power != zero; ++k, power = power >> step)
        sum = i == 0 || k % 2 == 1 ? sum + power / k : sum - power / k;
    return sum;
}

/// |value - entry| <= half, all times the same unit.
void expect_nearest(const BigFixed& value, const BigFixed& entry, const BigFixed& half)
{
    EXPECT_TRUE(value <= entry + half);
    EXPECT_TRUE(entry <= value + half);
}

TEST(MandelbulbTables, Angles)
{
    // Times 2 pi: atan(2^-i) * 2^64 lies within pi of 2 pi times the entry. Both times 2^-64 here.
    const BigFixed turn = pi() * 2 >> 64;
    EXPECT_EQ(angles[0], std::uint64_t{1} << 61);
    for (int i = 1; i < max_steps; ++i) {
        SCOPED_TRACE(i);
        const BigFixed exact = arc_tangent(one >> i, [&](const BigFixed& x) { return x >> 2 * i; });
        expect_nearest(exact, times(turn, angles[static_cast<std::size_t>(i)]), turn >> 1);
    }
}

TEST(MandelbulbTables, Logarithms)
{
    constexpr auto narrow = logarithms_in<57>();
    constexpr auto wide = logarithms_in<64>();
    for (int i = 0; i < max_steps; ++i) {
        SCOPED_TRACE(i);
        const auto at = static_cast<std::size_t>(i);
        expect_nearest(logarithm_of(i), times(one >> 64, wide[at]), one >> 65);
        expect_nearest(logarithm_of(i), times(one >> 57, narrow[at]), one >> 58);
    }
}

TEST(MandelbulbTables, Gains)
{
    // (C - 1/2)^2 < 2^126 / product of (1 + 4^-i) < (C + 1/2)^2, times the product and 2^-126.
    BigFixed product = one;
    for (int steps = 1; steps <= max_steps; ++steps) {
        product = product + (product >> 2 * (steps - 1));
        if (steps < min_steps)
            continue;
        SCOPED_TRACE(steps);
        const auto twice = static_cast<std::uint64_t>(gain_of(steps)) * 2;
        const auto squared = [&](std::uint64_t c) { return times(times(product >> 128, c), c); };
        EXPECT_TRUE(squared(twice - 1) < one);
        EXPECT_TRUE(one < squared(twice + 1));
    }
}

TEST(MandelbulbTables, EntriesByHand)
{
    EXPECT_EQ(gain_of(9), 0x4DBA'83C8'8A9B'422E);
    EXPECT_EQ(gain_of(32), 0x4DBA'76D4'21AF'2D34);
    EXPECT_EQ(gain_of(57), gain_of(32));
    EXPECT_EQ(logarithms_in<57>()[0], 0x0162'E42F'EFA3'9EF3U);
    EXPECT_EQ(logarithms_in<57>()[57], 1U);
    EXPECT_EQ(logarithms_in<57>()[58], 0U); // a tie but for the square of 2^-58
    EXPECT_EQ(angles[1], 0x12E4'051D'9DF3'0866U);
}

} // namespace
} // namespace raymarch::engine::mandelbulb
