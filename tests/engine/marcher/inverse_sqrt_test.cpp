// SPDX-License-Identifier: MIT
#include "engine/marcher/inverse_sqrt.hpp"

#include "tests/fakes/random.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <limits>
#include <string>

namespace raymarch::engine::marcher
{
namespace
{

/// The corners of the interpolation: 14 bits between two entries, and what is below them.
constexpr std::uint64_t steps[] = {0, 1, 8191, 8192, 16383};
constexpr std::uint64_t rests[] = {0, (std::uint64_t{1} << 37) - 1};

/// A 64-bit number with its top bit set, of table entry `index`.
constexpr std::uint64_t normalised(std::uint64_t index, std::uint64_t step, std::uint64_t rest)
{
    return std::uint64_t{1} << 63 | index << 51 | step << 37 | rest;
}

/// Calls `check(S)` for every table entry and every exponent, at the corners of the interpolation.
template <typename Check>
void for_all_corners(Check check)
{
    for (int zeros = 0; zeros < 64; ++zeros)
        for (std::uint64_t index = 0; index < 4096; ++index)
            for (const std::uint64_t step : steps)
                for (const std::uint64_t rest : rests)
                    check(normalised(index, step, rest) >> zeros);
}

#ifdef __SIZEOF_INT128__ // an independent wide integer; 32-bit targets have none
__extension__ typedef unsigned __int128 Exact; // NOLINT(modernize-use-using)

TEST(InverseSqrt, RelativeErrorIsBelow2ToTheMinus25)
{
    // mantissa = 2^(24 + shift) / sqrt(S) * (1 + e), so mantissa^2 * S = 2^(48 + 2 shift) * (1 +
    // e)^2, and |e| < 2^-25 makes the difference less than 2^(24 + 2 shift). All of it fits 126
    // bits.
    int wrong = 0;
    for_all_corners([&](std::uint64_t squared) {
        const InverseSqrt inverse = inverse_sqrt(squared);
        const Exact got = Exact{inverse.mantissa} * inverse.mantissa * squared;
        const Exact exact = Exact{1} << (48 + 2 * inverse.shift);
        const Exact difference = got > exact ? got - exact : exact - got;
        if (difference >= Exact{1} << (24 + 2 * inverse.shift) && ++wrong < 10)
            ADD_FAILURE() << "S = " << squared;
    });
    EXPECT_EQ(wrong, 0);
}
#endif

TEST(InverseSqrt, MantissaAndShiftStayInTheirRanges)
{
    std::uint32_t least = UINT32_MAX;
    std::uint32_t most = 0;
    int least_shift = 64;
    int most_shift = 0;
    for_all_corners([&](std::uint64_t squared) {
        const InverseSqrt inverse = inverse_sqrt(squared);
        least = std::min(least, inverse.mantissa);
        most = std::max(most, inverse.mantissa);
        least_shift = std::min(least_shift, inverse.shift);
        most_shift = std::max(most_shift, inverse.shift);
    });
    EXPECT_GE(least, 759'250'124U);  // 2^30 / sqrt(2) = 759250124.99
    EXPECT_LE(most, 1'518'500'250U); // T[0] = round(2^30 * sqrt(2))
    EXPECT_EQ(least_shift, 6);       // S = 1: 63 leading zeros
    EXPECT_EQ(most_shift, 38);       // none
}

/// 1 / sqrt(S) as the stage has it; exact in long double.
long double value_of(std::uint64_t squared)
{
    const InverseSqrt inverse = inverse_sqrt(squared);
    return std::ldexp(static_cast<long double>(inverse.mantissa), -inverse.shift);
}

TEST(InverseSqrt, NeverRises)
{
    for (int zeros = 63; zeros >= 0; --zeros) {
        long double before = std::numeric_limits<long double>::infinity();
        for (std::uint64_t index = 0; index < 4096; ++index) {
            for (const std::uint64_t step : steps) {
                const std::uint64_t squared = normalised(index, step, 0) >> zeros;
                const long double value = value_of(squared);
                ASSERT_LE(value, before) << "S = " << squared;
                before = value;
            }
        }
    }
}

TEST(InverseSqrt, NeverRisesFromOneExponentToTheNext)
{
    for (int bit = 1; bit < 64; ++bit) {
        const std::uint64_t power = std::uint64_t{1} << bit;
        EXPECT_LE(value_of(power), value_of(power - 1)) << "2^" << bit;
    }
}

TEST(InverseSqrt, TheEntriesThatTheDefinitionNames)
{
    const InverseSqrt first = inverse_sqrt(std::uint64_t{1} << 63); // no leading zero, T[0]
    EXPECT_EQ(first.mantissa, 1'518'500'250U);
    EXPECT_EQ(first.shift, 38);
    EXPECT_EQ(inverse_sqrt(normalised(1, 0, 0)).mantissa, 1'518'314'920U); // T[1]
}

TEST(SquaredLength, IsExactUpToTheLargestVector)
{
    constexpr std::int32_t least = std::numeric_limits<std::int32_t>::min();
    EXPECT_EQ(squared_length({0, 0, 0}), 0U);
    EXPECT_EQ(squared_length({1, -2, 3}), 14U);
    EXPECT_EQ(squared_length({least, least, least}), std::uint64_t{3} << 62);
}

/// A vector whose size is any power of two.
RawVector random_vector(std::mt19937_64& random)
{
    const int shift = test::pick(random, 0, 30);
    const auto component = [&] {
        return static_cast<std::int32_t>(random() & 0xFFFF'FFFF) >> shift;
    };
    return {component(), component(), component()};
}

TEST(Normalise, AgreesWithLongDouble)
{
    auto random = test::seeded_random();
    for (int i = 0; i < 200'000; ++i) {
        const RawVector v = random_vector(random);
        const long double length = std::sqrt(static_cast<long double>(squared_length(v)));
        if (length == 0)
            continue;
        const Point unit = normalise(v);
        const auto expect = [&](Coordinate got, std::int32_t component) {
            const long double exact = static_cast<long double>(component) / length * 0x1p24L;
            // Half a raw from the relative error, one from the floor.
            ASSERT_LE(std::fabs(static_cast<long double>(got.raw()) - exact), 1.5L)
                << v.x << ' ' << v.y << ' ' << v.z;
        };
        expect(unit.x, v.x);
        expect(unit.y, v.y);
        expect(unit.z, v.z);
    }
}

TEST(Normalise, TheZeroVectorStaysZero)
{
    EXPECT_EQ(normalise({0, 0, 0}), Point{});
}

TEST(Normalise, TheSmallestVectorIsAUnitVectorToo)
{
    EXPECT_NEAR(normalise({1, 0, 0}).x.raw(), 1 << 24, 1);
    EXPECT_NEAR(normalise({0, -1, 0}).y.raw(), -(1 << 24), 1);
    EXPECT_EQ(normalise({1, 0, 0}).y.raw(), 0);
}

TEST(Length, AgreesWithLongDouble)
{
    auto random = test::seeded_random();
    for (int i = 0; i < 200'000; ++i) {
        RawVector v = random_vector(random);
        if (squared_length(v) >= std::uint64_t{1} << 62) // 128 and above do not fit
            v = map(v, [](std::int32_t c) { return c / 2; });
        const Point p = map(v, [](std::int32_t c) { return Coordinate::from_raw(c); });
        const long double exact = std::sqrt(static_cast<long double>(squared_length(v)));
        ASSERT_LE(std::fabs(static_cast<long double>(length(p).raw()) - exact),
                  1 + exact * 0x1p-25L)
            << v.x << ' ' << v.y << ' ' << v.z;
    }
}

TEST(Length, TheZeroVectorHasLengthZero)
{
    EXPECT_EQ(length(Point{}).raw(), 0);
}

} // namespace
} // namespace raymarch::engine::marcher
