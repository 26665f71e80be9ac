// SPDX-License-Identifier: MIT
#include "engine/whitted/arithmetic.hpp"

#include "tests/engine/whitted/report.hpp"
#include "tests/fakes/random.hpp"

#include <gtest/gtest.h>

namespace raymarch::engine::whitted
{
namespace
{

using test::number;
using test::read_table;
using test::word;

TEST(Whitted, SquareRootsOfTheTable)
{
    for (const test::Columns& row : read_table("sqrt.tsv"))
        EXPECT_EQ(square_root(static_cast<std::uint32_t>(number(row.at(0)))).raw(),
                  number(row.at(1)))
            << row.at(0);
}

TEST(Whitted, TheSquareRootIsFloored)
{
    for (std::uint32_t v = 0; v < 1U << 24; v += v < 5000 ? 1 : 997) {
        const std::int64_t root = square_root(v).raw();
        const std::int64_t argument = std::int64_t{v} << 12;
        ASSERT_LE(root * root, argument) << v;
        ASSERT_GT((root + 1) * (root + 1), argument) << v;
    }
}

TEST(Whitted, ARootTakesBits35To12)
{
    const auto root = [](std::int64_t raw) { return root_of(Wide::from_raw(raw)).raw(); };
    EXPECT_EQ(root(4095), 0);
    EXPECT_EQ(root(4096), 64);
    EXPECT_EQ(root((std::int64_t{1} << 36) - 1), 262143);
    EXPECT_EQ(root(std::int64_t{1} << 36), 0); // 64 squared
    EXPECT_EQ(root((std::int64_t{1} << 40) + 4096), 64);
    EXPECT_EQ(root(-1), 262143);
}

TEST(Whitted, QuotientsOfTheTable)
{
    for (const test::Columns& row : read_table("divide.tsv"))
        EXPECT_EQ(divide(word(row.at(0)), word(row.at(1))).raw(), number(row.at(2)))
            << row.at(0) << " / " << row.at(1);
}

TEST(Whitted, RemaindersAreNeverNegative)
{
    std::mt19937_64 random = raymarch::test::seeded_random();
    for (int i = 0; i < 20'000; ++i) {
        // Denominators large enough for the quotient to fit.
        const int n = raymarch::test::pick(random, -(1 << 23), (1 << 23) - 1);
        const int magnitude = raymarch::test::pick(random, 1 << 13, (1 << 23) - 1);
        const int d = (i & 1) != 0 ? -magnitude : magnitude;
        const std::int64_t q = divide(Word::from_raw(n), Word::from_raw(d)).raw();
        const std::int64_t remainder = std::int64_t{n} * 4096 - q * d;
        ASSERT_GE(remainder, 0) << n << " / " << d;
        ASSERT_LT(remainder, magnitude) << n << " / " << d;
    }
}

TEST(Whitted, DirectionsOfTheTable)
{
    for (const test::Columns& row : read_table("normalise.tsv"))
        EXPECT_EQ(test::raw(normalise(test::vector_at(row, 0))), test::raw(test::vector_at(row, 3)))
            << row.at(0) << ' ' << row.at(1) << ' ' << row.at(2);
}

TEST(Whitted, TheZeroVectorHasNoDirection)
{
    EXPECT_EQ(normalise({}), Vector{});
}

TEST(Whitted, ProductsAndSumsWrapAt48Bits)
{
    const Word least = Word::from_raw(-(1 << 23));
    EXPECT_EQ((least * least).raw(), std::int64_t{1} << 46);
    EXPECT_EQ(dot({least, least, {}}, {least, least, {}}).raw(), -(std::int64_t{1} << 47));
}

} // namespace
} // namespace raymarch::engine::whitted
