// SPDX-License-Identifier: MIT
/// @file
/// Every expected code was worked out by hand; the comment on its row gives the reason.
#include "base/fixed.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cstdint>

namespace raymarch
{
namespace
{

using Halves = Q<8, 1>;   // one bit to drop
using Quarters = Q<8, 2>; // two bits to drop
using Floored = Q<8, 0>;
using Rounded = Q<8, 0, Rounding::NearestEven>;

struct NarrowRow
{
    int raw; ///< in halves or quarters
    int floored;
    int rounded;
};

constexpr std::array halves = {
    NarrowRow{-3, -2, -2}, // -1.5 lies between -2 and -1: the even one
    NarrowRow{-2, -1, -1}, // exact
    NarrowRow{-1, -1, 0},  // -0.5: a shift goes to -1, the even neighbour is 0
    NarrowRow{0, 0, 0},    //
    NarrowRow{1, 0, 0},    // 0.5: down to the even 0
    NarrowRow{2, 1, 1},    // exact
    NarrowRow{3, 1, 2},    // 1.5: up to the even 2
    NarrowRow{5, 2, 2},    // 2.5: down to the even 2
};

TEST(Fixed, NarrowingHalvesIsAsItsRoundingSays)
{
    for (const NarrowRow& row : halves) {
        EXPECT_EQ(narrow<Floored>(Halves::from_raw(row.raw)).raw(), row.floored) << row.raw << "/2";
        EXPECT_EQ(narrow<Rounded>(Halves::from_raw(row.raw)).raw(), row.rounded) << row.raw << "/2";
    }
}

constexpr std::array quarters = {
    NarrowRow{-7, -2, -2}, // -1.75 is nearer to -2
    NarrowRow{-6, -2, -2}, // -1.5: tie, even
    NarrowRow{-5, -2, -1}, // -1.25 is nearer to -1
    NarrowRow{-3, -1, -1}, // -0.75
    NarrowRow{-2, -1, 0},  // -0.5: tie, even
    NarrowRow{-1, -1, 0},  // -0.25
    NarrowRow{1, 0, 0},    // 0.25
    NarrowRow{2, 0, 0},    // 0.5: tie, even
    NarrowRow{3, 0, 1},    // 0.75
    NarrowRow{6, 1, 2},    // 1.5: tie, even
};

TEST(Fixed, NarrowingQuartersIsAsItsRoundingSays)
{
    for (const NarrowRow& row : quarters) {
        EXPECT_EQ(narrow<Floored>(Quarters::from_raw(row.raw)).raw(), row.floored)
            << row.raw << "/4";
        EXPECT_EQ(narrow<Rounded>(Quarters::from_raw(row.raw)).raw(), row.rounded)
            << row.raw << "/4";
    }
}

TEST(Fixed, NarrowingAllOfASmallFormatAgreesWithDivision)
{
    for (int raw = Quarters::min_raw; raw <= Quarters::max_raw; ++raw) {
        const int floor = raw >= 0 ? raw / 4 : -((-raw + 3) / 4);
        EXPECT_EQ(narrow<Floored>(Quarters::from_raw(raw)).raw(), floor) << raw << "/4";
    }
}

using Wide = Q<8, 0>;
using Wrapped4 = Q<4, 0>;
using Held4 = Q<4, 0, Rounding::Floor, Overflow::Saturate>;

struct OverflowRow
{
    int raw;
    int wrapped;
    int held;
};

constexpr std::array overflows = {
    OverflowRow{7, 7, 7},     // the largest code
    OverflowRow{8, -8, 7},    // 1000 read as signed
    OverflowRow{16, 0, 7},    // only the low four bits stay
    OverflowRow{127, -1, 7},  // 1111
    OverflowRow{-8, -8, -8},  // the smallest code
    OverflowRow{-9, 7, -8},   // ...0111
    OverflowRow{-128, 0, -8}, // ...0000
};

TEST(Fixed, NarrowingOverflowsAsItsFormatSays)
{
    for (const OverflowRow& row : overflows) {
        EXPECT_EQ(narrow<Wrapped4>(Wide::from_raw(row.raw)).raw(), row.wrapped) << row.raw;
        EXPECT_EQ(narrow<Held4>(Wide::from_raw(row.raw)).raw(), row.held) << row.raw;
    }
}

TEST(Fixed, RoundingUpMayOverflow)
{
    using RoundedWrap = Q<4, 0, Rounding::NearestEven, Overflow::Wrap>;
    using RoundedHeld = Q<4, 0, Rounding::NearestEven, Overflow::Saturate>;
    const auto seven_and_a_half = Q<4, 1>::from_raw(15);
    EXPECT_EQ(narrow<RoundedWrap>(seven_and_a_half).raw(), -8); // 8 is 1000
    EXPECT_EQ(narrow<RoundedHeld>(seven_and_a_half).raw(), 7);
}

TEST(Fixed, UnsignedNarrowingOverflows)
{
    using Held = UQ<4, 0, Rounding::Floor, Overflow::Saturate>;
    EXPECT_EQ((narrow<UQ<4, 0>>(UQ<8, 0>::from_raw(255U)).raw()), 15U);
    EXPECT_EQ((narrow<UQ<4, 0>>(UQ<8, 0>::from_raw(16U)).raw()), 0U);
    EXPECT_EQ((narrow<Held>(UQ<8, 0>::from_raw(16U)).raw()), 15U);
    EXPECT_EQ((narrow<Held>(UQ<8, 4>::from_raw(0x0FFU)).raw()), 15U); // 15.9375
}

TEST(Fixed, CodesNarrowerThanTheirStorageAreSignExtended)
{
    using Direction = Q<1, 17>;
    EXPECT_EQ(Direction::max_raw, 131071);
    EXPECT_EQ(Direction::min_raw, -131072);
    EXPECT_EQ(Direction::from_raw(131071).raw(), 131071);
    EXPECT_EQ(Direction::from_raw(131072).raw(), -131072); // bit 17 is the sign
    EXPECT_EQ(Direction::from_raw(0x3FFFF).raw(), -1);
    EXPECT_EQ(Direction::from_raw(0x40000).raw(), 0); // beyond the width
    EXPECT_EQ((UQ<0, 10>::from_raw(1024).raw()), 0U);
    EXPECT_EQ((UQ<0, 10>::from_raw(-1).raw()), 1023U);
}

TEST(Fixed, WidthsAtTheirLimits)
{
    EXPECT_EQ((Q<1, 0>::max_raw), 0);
    EXPECT_EQ((Q<1, 0>::min_raw), -1);
    EXPECT_EQ((UQ<1, 0>::max_raw), 1U);
    EXPECT_EQ((Q<32, 0>::max_raw), INT32_MAX);
    EXPECT_EQ((Q<32, 0>::min_raw), INT32_MIN);
    EXPECT_EQ((Q<33, 0>::max_raw), std::int64_t{UINT32_MAX});
    EXPECT_EQ((Q<64, 0>::max_raw), INT64_MAX);
    EXPECT_EQ((UQ<64, 0>::max_raw), UINT64_MAX);
}

TEST(Fixed, SumsWrap)
{
    EXPECT_EQ((Wrapped4::from_raw(7) + Wrapped4::from_raw(1)).raw(), -8);
    EXPECT_EQ((Wrapped4::from_raw(-8) - Wrapped4::from_raw(1)).raw(), 7);
    EXPECT_EQ((-Wrapped4::from_raw(-8)).raw(), -8); // has no positive counterpart
    using Full = Q<32, 0>;
    EXPECT_EQ((Full::from_raw(INT32_MAX) + Full::from_raw(1)).raw(), INT32_MIN);
    EXPECT_EQ((Full::from_raw(INT32_MIN) - Full::from_raw(1)).raw(), INT32_MAX);
}

TEST(Fixed, SumsHold)
{
    EXPECT_EQ((Held4::from_raw(7) + Held4::from_raw(1)).raw(), 7);
    EXPECT_EQ((Held4::from_raw(-8) + Held4::from_raw(-8)).raw(), -8);
    EXPECT_EQ((Held4::from_raw(-8) - Held4::from_raw(1)).raw(), -8);
    EXPECT_EQ((-Held4::from_raw(-8)).raw(), 7);
}

TEST(Fixed, SumsHoldWhereTheStorageItselfOverflows)
{
    using Full = Q<32, 0, Rounding::Floor, Overflow::Saturate>;
    EXPECT_EQ((Full::from_raw(INT32_MAX) + Full::from_raw(INT32_MAX)).raw(), INT32_MAX);
    EXPECT_EQ((Full::from_raw(INT32_MIN) + Full::from_raw(INT32_MIN)).raw(), INT32_MIN);
    EXPECT_EQ((Full::from_raw(0) - Full::from_raw(INT32_MIN)).raw(), INT32_MAX);
    EXPECT_EQ((-Full::from_raw(INT32_MIN)).raw(), INT32_MAX);
    using Long = Q<64, 0, Rounding::Floor, Overflow::Saturate>;
    EXPECT_EQ((Long::from_raw(INT64_MIN) - Long::from_raw(1)).raw(), INT64_MIN);
}

TEST(Fixed, UnsignedSumsWrapOrHold)
{
    using Held = UQ<4, 0, Rounding::Floor, Overflow::Saturate>;
    EXPECT_EQ((UQ<4, 0>::from_raw(15U) + UQ<4, 0>::from_raw(1U)).raw(), 0U);
    EXPECT_EQ((UQ<4, 0>::from_raw(3U) - UQ<4, 0>::from_raw(5U)).raw(), 14U);
    EXPECT_EQ((Held::from_raw(15U) + Held::from_raw(1U)).raw(), 15U);
    EXPECT_EQ((Held::from_raw(3U) - Held::from_raw(5U)).raw(), 0U);
    using Full = UQ<32, 0, Rounding::Floor, Overflow::Saturate>;
    EXPECT_EQ((Full::from_raw(UINT32_MAX) + Full::from_raw(1U)).raw(), UINT32_MAX);
    EXPECT_EQ((Full::from_raw(0U) - Full::from_raw(1U)).raw(), 0U);
}

TEST(Fixed, ProductsAreExact)
{
    using Coordinate = Q<8, 24>;
    const auto product = Coordinate::from_raw(INT32_MIN) * Coordinate::from_raw(INT32_MIN);
    static_assert(decltype(product)::integer_bits == 16 && decltype(product)::fraction_bits == 48);
    EXPECT_EQ(product.raw(), std::int64_t{1} << 62);
    EXPECT_EQ((Coordinate::from_raw(-1) * Coordinate::from_raw(1)).raw(), -1);
    EXPECT_EQ(narrow<Coordinate>(Coordinate::from_raw(-1) * Coordinate::from_raw(1)).raw(),
              -1); // -2^-48 floored to 24 bits
    const auto mixed = UQ<8, 8>::from_raw(0xFFFFU) * UQ<0, 8>::from_raw(0xFFU);
    static_assert(decltype(mixed)::width == 24);
    EXPECT_EQ(mixed.raw(), 0xFEFF01U); // 65535 * 255 = 16711425
}

TEST(Fixed, ComparesByValue)
{
    EXPECT_LT(Wide::from_raw(-1), Wide::from_raw(0));
    EXPECT_EQ(Wide::from_raw(256), Wide::from_raw(0)); // the same code
}

} // namespace
} // namespace raymarch
