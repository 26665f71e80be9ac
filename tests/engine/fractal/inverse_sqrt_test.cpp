// SPDX-License-Identifier: MIT
#include "engine/fractal/inverse_sqrt.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace raymarch::engine::fractal
{
namespace
{

TEST(InverseSqrt, IsNearFromAHalfOn)
{
    double worst = 0;
    for (std::int32_t raw = 1 << 15; raw < 1 << 21; ++raw) {
        const double exact = 65536 / std::sqrt(raw / 65536.0);
        worst = std::max(worst, std::abs(inverse_sqrt(word(raw)).raw() - exact) / exact);
    }
    EXPECT_LT(worst, 0.001);
}

TEST(InverseSqrt, SmallWordsAreNotNormalised)
{
    // The line gives sqrt(2) + (sqrt(2) - 1) at 0, and each round half as much again.
    EXPECT_NEAR(inverse_sqrt(word(0)).raw(), 1.828415 * 2.25 * 65536, 8);
    EXPECT_LT(inverse_sqrt(word(1 << 10)), five); // the root would be 8
}

TEST(InverseSqrt, ANegativeWordCountsAs64More)
{
    EXPECT_NEAR(inverse_sqrt(word(-2097152)).raw(), 65536 / std::sqrt(32), 12);
    EXPECT_NEAR(inverse_sqrt(word(-1)).raw(), 65536 / 8.0, 12);
}

} // namespace
} // namespace raymarch::engine::fractal
