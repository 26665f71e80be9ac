// SPDX-License-Identifier: MIT
#include "engine/fractal/formats.hpp"

#include <gtest/gtest.h>

namespace raymarch::engine::fractal
{
namespace
{

constexpr Number lowest = word(-2097152); // -32
constexpr Number highest = word(2097151);

// The word rules: wrapping, flooring, |-32|, logical shifts, fractions of negative words.
static_assert(highest + word(1) == lowest);
static_assert(-lowest == lowest && absolute(lowest) == lowest);
static_assert(multiply(word(-1), word(1)) == word(-1));
static_assert(multiply(word(1), word(65535)) == word(0));
static_assert(multiply(lowest, lowest) == word(0)); // 1024 wraps
static_assert(multiply(five, word(7 << 16)) == word((35 - 64) * 65536));
static_assert(shift_right(word(-1), 1) == highest && shift_right(word(-1), 16) == word(63));
static_assert(fraction(word(-1)) == word(65535) && fraction(word(-65536)) == word(0));
static_assert(floor(word(-1)) == -one && floor(word(65535)) == word(0) && floor(one) == one);
static_assert(middle({one, half, quarter}) == half && middle({half, one, quarter}) == half &&
              middle({quarter, one, half}) == half && middle({one, one, quarter}) == one);

TEST(Words, AreTheirLow22Bits)
{
    EXPECT_EQ(word(0x3E8000).raw(), -98304);
    EXPECT_EQ(word(0x200000), lowest);
}

} // namespace
} // namespace raymarch::engine::fractal
