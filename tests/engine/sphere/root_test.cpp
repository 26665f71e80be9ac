// SPDX-License-Identifier: MIT
#include "engine/sphere/root.hpp"

#include "tests/fakes/random.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace raymarch::engine::sphere
{
namespace
{

constexpr std::uint64_t ones = UINT64_MAX;

static_assert(unsigned_product(ones, ones) == Wide{ones - 1, 1});
static_assert(unsigned_product(0x1'0000'0001, 0xFFFF'FFFF) == Wide{0, ones});
static_assert(product(-1, 1) == Wide{ones, ones});
static_assert(product(-1, -1) == Wide{0, 1});
static_assert(product(INT64_MIN, INT64_MIN) == Wide{std::uint64_t{1} << 62, 0});
static_assert(product(INT64_MIN, 1) == Wide{ones, std::uint64_t{1} << 63});
static_assert(product(INT64_MIN, INT64_MAX) == Wide{0xC000'0000'0000'0000, std::uint64_t{1} << 63});
static_assert(product(3, 5) - product(4, 4) == Wide{ones, ones});
static_assert((product(3, 5) - product(4, 4)).is_negative());
static_assert(Wide{1, 0} - Wide{0, 1} == Wide{0, ones});
static_assert(bit_width(Wide{}) == 0 && bit_width(Wide{0, ones}) == 64 &&
              bit_width(Wide{1, 0}) == 65);

#if defined(__SIZEOF_INT128__)
__extension__ using Int128 = __int128;

TEST(SphereWide, ProductsAndDifferencesAreThoseOfTheCompilersNumbers)
{
    auto random = test::seeded_random();
    const auto wide = [](Int128 v) {
        return Wide{static_cast<std::uint64_t>(v >> 64), static_cast<std::uint64_t>(v)};
    };
    const auto any = [&] {
        return static_cast<std::int64_t>(random()) >> test::pick(random, 0, 63);
    };
    for (int i = 0; i < 20'000; ++i) {
        const std::int64_t a = any();
        const std::int64_t b = any();
        const std::int64_t c = any();
        const Int128 ab = Int128{a} * b;
        const Int128 cc = Int128{c / 2} * c;
        EXPECT_EQ(product(a, b), wide(ab)) << a << ' ' << b;
        EXPECT_EQ(product(a, b) - product(c / 2, c), wide(ab - cc)) << a << ' ' << b << ' ' << c;
    }
}
#endif

TEST(SphereRoot, TheExactRootEndsAtSquares)
{
    EXPECT_EQ(floor_root({}), 0U);
    auto random = test::seeded_random();
    for (int i = 0; i < 5'000; ++i) {
        const std::uint64_t root = random() >> test::pick(random, 1, 63);
        const Wide square = unsigned_product(root, root);
        EXPECT_EQ(floor_root(square), root);
        if (root > 0) {
            EXPECT_EQ(floor_root(square - Wide{0, 1}), root - 1);
        }
        const Wide next = unsigned_product(root + 1, root + 1);
        EXPECT_EQ(floor_root(next - Wide{0, 1}), root);
    }
}

/// What the C program computes; the conversion and the root are IEEE 754's.
std::uint64_t by_floating_point(std::uint64_t v)
{
    return static_cast<std::uint64_t>(std::sqrt(static_cast<double>(v)));
}

TEST(SphereRoot, TheRoundedRootIsThatOfADouble)
{
    auto random = test::seeded_random();
    for (int i = 0; i < 100'000; ++i) {
        const std::uint64_t v = random() >> test::pick(random, 0, 63);
        EXPECT_EQ(rounded_root({0, v}), by_floating_point(v)) << v;
    }
}

/// Below a square is where it matters: n^2 - k still has the root n when k is small enough.
TEST(SphereRoot, TheRoundedRootJustBelowSquares)
{
    auto random = test::seeded_random();
    int rounded_up = 0;
    for (int i = 0; i < 100'000; ++i) {
        const std::uint64_t n = (random() >> test::pick(random, 32, 40)) + 1;
        const std::uint64_t below = test::pick<std::uint64_t>(random, 1, 1 + (n >> 19));
        const std::uint64_t v = n * n - std::min(below, n * n);
        EXPECT_EQ(rounded_root({0, v}), by_floating_point(v)) << v;
        rounded_up += rounded_root({0, v}) != floor_root({0, v}) ? 1 : 0;
    }
    EXPECT_GT(rounded_up, 1'000);
}

struct RoundedRow
{
    std::uint64_t v;
    std::uint64_t root;
};

constexpr std::uint64_t two_26 = std::uint64_t{1} << 26;
constexpr std::uint64_t two_27 = std::uint64_t{1} << 27;
constexpr std::uint64_t two_31 = std::uint64_t{1} << 31;

constexpr std::array rounded_rows = {
    RoundedRow{0, 0},
    RoundedRow{1, 1},
    RoundedRow{two_26 * two_26 - 1, two_26 - 1},   // below 2^52 it is the exact root
    RoundedRow{two_27 * two_27 - 1, two_27},       // 2^-28 missing, numbers 2^-26 apart
    RoundedRow{two_27 * two_27 - 2, two_27 - 1},   // 2^-27 missing, and a little: over half
    RoundedRow{two_31 * two_31 - 256, two_31},     // the conversion: a tie, to the even 2^62
    RoundedRow{two_31 * two_31 - 257, two_31 - 1}, // the conversion down to 2^62 - 512
    RoundedRow{UINT64_MAX, std::uint64_t{1} << 32},
};

TEST(SphereRoot, RoundedRootsByHand)
{
    for (const RoundedRow& row : rounded_rows) {
        EXPECT_EQ(rounded_root({0, row.v}), row.root) << row.v;
        EXPECT_EQ(by_floating_point(row.v), row.root) << row.v;
    }
}

} // namespace
} // namespace raymarch::engine::sphere
