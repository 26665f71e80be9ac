// SPDX-License-Identifier: MIT
#include "engine/fractal/scenes.hpp"

#include "tests/fakes/random.hpp"

#include <gtest/gtest.h>

namespace raymarch::engine::fractal
{
namespace
{

constexpr Number value(double v)
{
    return word(static_cast<std::int32_t>(v * 65536));
}

constexpr Point at(double x, double y, double z)
{
    return {value(x), value(y), value(z)};
}

TEST(Scenes, RowsStandInTheOrderOfTheirCodes)
{
    for (unsigned code = 0; code < 4; ++code)
        EXPECT_EQ(scene_row(static_cast<Scene>(code)).scene, static_cast<Scene>(code));
}

TEST(Scenes, CubeByHand)
{
    EXPECT_EQ(cube({}), -half);
    EXPECT_EQ(cube(at(0, 1, -1.5)), one);
    EXPECT_EQ(cube(at(-2, 0.5, 1)), three_halves);
    EXPECT_EQ(cube(at(-32, -32, -32)), value(31.5)); // |-32| is -32, and half less wraps
}

TEST(Scenes, CubesByHand)
{
    EXPECT_EQ(cubes({}), -quarter);
    EXPECT_EQ(cubes(at(0.5, 0, 0)), quarter);
    EXPECT_EQ(cubes(at(-3, 7, 0.375)), value(0.125));
    EXPECT_EQ(cubes(at(-0.5, -0.25, 0)), quarter);
}

TEST(Scenes, MengerByHand)
{
    // At a corner of the largest cells the first term is middle(1, 1, 1) - 0.45.
    EXPECT_EQ(menger({}), word(65536 - 29492));
    // In the middle of the largest cell: of the four terms, in turn 0, 1/2, 1/4 and 1/16 less
    // 0.45, 0.28333, 0.18167 and 0.05.
    EXPECT_EQ(menger(at(1, 1, 1)), word(32768 - 18569));
    // In the bar along z all the small terms are at x = y = 1.
    EXPECT_EQ(menger(at(1, 1, -1.5)), menger(at(1, 1, 0.5)));
}

TEST(Scenes, TheLargestCellsOfTheSpongeLoseABit)
{
    const auto diagonal = [](std::int32_t from_middle) { // where the first term decides
        const Number c = one + word(from_middle);
        return menger({c, c, c});
    };
    EXPECT_EQ(diagonal(40'000), word(40'000 - 29'492));
    EXPECT_EQ(diagonal(40'001), diagonal(40'000));
    EXPECT_EQ(diagonal(40'002), word(40'002 - 29'492));
}

TEST(Scenes, MazeTiesAndZeros)
{
    // In the middle of a cell q is 0 on every axis: all w are 0, id is the middle itself.
    // hash of (0.5, 0.5, 0.5) = 0.75 + 10922 / 65536 + 0.125 = 1.04166: 2730, not above a third.
    EXPECT_EQ(maze(at(0.5, 0.5, 0.5)), -sixteenth);
    // At a corner q is -1/2 on every axis, a tie: id = (0, 0, 0), hash 0, across x and y.
    EXPECT_EQ(maze({}), half - sixteenth);
}

TEST(Scenes, PatternsRepeat)
{
    std::mt19937_64 random = raymarch::test::seeded_random();
    const auto any = [&] { return word(raymarch::test::pick(random, -2097152, 2097151)); };
    for (int i = 0; i < 5000; ++i) {
        const Point p{any(), any(), any()};
        const Point two{p.x + one + one, p.y - one - one, p.z + one + one};
        EXPECT_EQ(menger(p), menger(two));
        EXPECT_EQ(cubes(p), cubes({p.x + one, p.y - one, p.z + one}));
    }
}

} // namespace
} // namespace raymarch::engine::fractal
