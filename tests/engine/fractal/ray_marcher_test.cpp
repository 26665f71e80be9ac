// SPDX-License-Identifier: MIT
#include "engine/fractal/ray_marcher.hpp"

#include <gtest/gtest.h>

namespace raymarch::engine::fractal
{
namespace
{

constexpr Point ahead{word(0), word(0), one};

// Distances that put one rule to the test, whatever the point is.
Number at_limit(const Point& /*p*/) noexcept
{
    return word(327);
}
Number below_limit(const Point& /*p*/) noexcept
{
    return word(326);
}
Number at_five(const Point& /*p*/) noexcept
{
    return five;
}
Number above_five(const Point& /*p*/) noexcept
{
    return five + word(1);
}
Number near_at_31(const Point& p) noexcept
{
    return p.z == word(31 << 16) ? word(0) : one;
}

TEST(RayMarcher, TheLimitsAreExclusive)
{
    EXPECT_EQ(march({}, ahead, at_limit).depth, 31);
    EXPECT_FALSE(march({}, ahead, at_limit).hit);
    EXPECT_EQ(march({}, ahead, below_limit).depth, 0);
    EXPECT_TRUE(march({}, ahead, below_limit).hit);
    EXPECT_EQ(march({}, ahead, at_five).depth, 31);
    EXPECT_EQ(march({}, ahead, above_five).depth, 0);
    EXPECT_FALSE(march({}, ahead, above_five).hit);
}

TEST(RayMarcher, TheLastQueryMayHit)
{
    const March ray = march({}, ahead, near_at_31);
    EXPECT_EQ(ray.depth, 31);
    EXPECT_TRUE(ray.hit);
    EXPECT_EQ(ray.point.z, word(31 << 16));
}

TEST(RayMarcher, InsideMatterHitsAtOnce)
{
    const March ray = march({}, ahead, cube);
    EXPECT_TRUE(ray.hit);
    EXPECT_EQ(ray.depth, 0);
    EXPECT_EQ(ray.point, Point{});
}

TEST(RayMarcher, StepsAreFloored)
{
    // Straight at the cube from 1 unit before it: one step of 1, exactly onto the face.
    const March ray = march({word(0), word(0), -three_halves}, ahead, cube);
    EXPECT_EQ(ray.depth, 1);
    EXPECT_EQ(ray.point.z, -half);
    const March aside = march({word(0), word(0), -three_halves}, {word(-1), word(0), one}, cube);
    EXPECT_EQ(aside.point.x, word(-1)); // -1 raw times 1
}

} // namespace
} // namespace raymarch::engine::fractal
