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

// With P = 16 p: the middle of a course is at Py = n + 1/2, where |v - 1/2| is 0: in the band
// of a tenth, which is where the joint lies.
TEST(Brick, JointsAndBricks)
{
    const auto at = [](double u, double v) { // P in units of a brick's half length and height
        return Point{word(static_cast<std::int32_t>(u * 2 * 4096)),
                     word(static_cast<std::int32_t>(v * 4096)), word(0)};
    };
    EXPECT_EQ(brick(at(0, 0), 9), 7);
    EXPECT_EQ(brick(at(0.25, 0.25), 9), 9); // u = 0.75 in an odd course: see below
    EXPECT_EQ(brick(at(0, 0.5), 9), 9);
}

TEST(Brick, TheNearestBricksWrapToBlack)
{
    EXPECT_EQ(brick({}, 0), 30);
    EXPECT_EQ(brick({}, 1), 31);
    EXPECT_EQ(brick({}, 2), 0);
    const Frame frame{.texture = true};
    EXPECT_EQ(grey(frame, hit(0), 0, 0), 0);
}

} // namespace
} // namespace raymarch::engine::fractal
