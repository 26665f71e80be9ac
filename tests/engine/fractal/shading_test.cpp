// SPDX-License-Identifier: MIT
#include "engine/fractal/shading.hpp"

#include <gtest/gtest.h>

namespace raymarch::engine::fractal
{
namespace
{

March hit(std::uint8_t depth, Point point = {})
{
    return {.hit = true, .depth = depth, .point = point};
}

TEST(Grey, DropsTheLastBitOfDepth)
{
    const Frame plain{};
    for (std::uint8_t depth = 0; depth <= max_depth; ++depth)
        EXPECT_EQ(grey(plain, hit(depth), 0, 1), 15 - depth / 2);
    EXPECT_EQ(grey(plain, {.hit = false, .depth = 3}, 0, 0), 0);
}

TEST(Grey, DithersOddDepthsAtOddPixels)
{
    const Frame frame{.dither = true};
    for (std::uint8_t depth = 0; depth <= max_depth; ++depth) {
        const int level = 15 - depth / 2;
        EXPECT_EQ(grey(frame, hit(depth), 3, 5), level);
        EXPECT_EQ(grey(frame, hit(depth), 4, 5), depth % 2 != 0 && level > 0 ? level - 1 : level);
    }
}

/// Where the texture has the coordinates u (bricks) and v (courses); joints run along v = n + 1/2.
Point textured(double u, double v)
{
    return {word(static_cast<std::int32_t>(u * 8192)), word(static_cast<std::int32_t>(v * 4096)),
            word(0)};
}

TEST(Brick, InACourseOfEvenNumber) // from v = 1/2 on
{
    EXPECT_EQ(brick(textured(0, 1), 9), 7);
    EXPECT_EQ(brick(textured(0.3, 1), 9), 7);
    EXPECT_EQ(brick(textured(0.45, 1), 9), 9);
    EXPECT_EQ(brick(textured(0.55, 1), 9), 9);
    EXPECT_EQ(brick(textured(0.7, 1), 9), 7);
    EXPECT_EQ(brick(textured(0, 1.45), 9), 9);
    EXPECT_EQ(brick(textured(0, 0.55), 9), 9);
}

TEST(Brick, InACourseOfOddNumberJointsAreHalfAsWide)
{
    EXPECT_EQ(brick(textured(0.05, 2), 9), 9);
    EXPECT_EQ(brick(textured(0.95, 2), 9), 7); // u is 1.45 there, and not reduced to 0.45
    EXPECT_EQ(brick(textured(0.45, 2), 9), 7);
    EXPECT_EQ(brick(textured(0.05, 0), 9), 9); // v from -1/2 on: course -1
}

TEST(Brick, BothHorizontalAxesRunAlongACourse)
{
    EXPECT_EQ(brick({word(0), word(4096), word(3686)}, 9), 9); // u = 0.45 by z
    EXPECT_EQ(brick({word(-3686), word(4096), word(0)}, 9), 9);
}

TEST(Brick, TheNearestBricksWrapToBlack)
{
    EXPECT_EQ(brick(textured(0, 1), 0), 30);
    EXPECT_EQ(brick(textured(0, 1), 1), 31);
    EXPECT_EQ(brick(textured(0, 1), 2), 0);
    const Frame frame{.texture = true};
    EXPECT_EQ(grey(frame, hit(0, textured(0, 1)), 0, 0), 0);
    EXPECT_EQ(grey(frame, hit(0, textured(0.45, 1)), 0, 0), 15);
}

} // namespace
} // namespace raymarch::engine::fractal
