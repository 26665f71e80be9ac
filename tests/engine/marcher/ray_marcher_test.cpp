// SPDX-License-Identifier: MIT
#include "engine/marcher/ray_marcher.hpp"

#include <gtest/gtest.h>

namespace raymarch::engine::marcher
{
namespace
{

constexpr Coordinate unit = ratio(1, 1);
constexpr Point ahead{Coordinate{}, Coordinate{}, ratio(-1, 1)};
constexpr Point to_the_right{unit, Coordinate{}, Coordinate{}};
constexpr Point from_three{Coordinate{}, Coordinate{}, ratio(3, 1)};

TEST(RayMarcher, ASphereIsHitHeadOnAtTheSecondQuery)
{
    const March ray = march(from_three, ahead, sphere); // 2 units away, then on it
    EXPECT_TRUE(ray.hit);
    EXPECT_EQ(ray.queries, 2);
    EXPECT_EQ(ray.point.x.raw(), 0);
    EXPECT_EQ(ray.point.y.raw(), 0);
    EXPECT_NEAR(ray.point.z.raw(), unit.raw(), 2);
}

TEST(RayMarcher, AwayFromASphereTheStepsDouble)
{
    // t = 2, 6, 14, 30: beyond 20 after the fourth query.
    const March ray = march(from_three, {Coordinate{}, Coordinate{}, unit}, sphere);
    EXPECT_FALSE(ray.hit);
    EXPECT_EQ(ray.queries, 4);
    EXPECT_NEAR(ray.point.z.raw(), 17 * unit.raw(), 20); // where the last query was made
}

TEST(RayMarcher, FromInsideTheFirstQueryHits)
{
    const March ray = march(Point{}, ahead, cube);
    EXPECT_TRUE(ray.hit);
    EXPECT_EQ(ray.queries, 1);
    EXPECT_EQ(ray.point, Point{});
}

// Distances that a scene would not have, so that one rule at a time decides.

Coordinate just_near(const Point& /*p*/) noexcept
{
    return Coordinate::from_raw(surface_distance.raw() - 1);
}
Coordinate just_not_near(const Point& /*p*/) noexcept
{
    return surface_distance;
}
Coordinate max_distance_away(const Point& /*p*/) noexcept
{
    return max_distance;
}
Coordinate near_beyond_ten(const Point& p) noexcept
{
    return p.x < ratio(10, 1) ? max_distance : Coordinate::from_raw(1);
}

TEST(RayMarcher, NearIsLessThanTheSurfaceDistance)
{
    EXPECT_TRUE(march(Point{}, to_the_right, just_near).hit);
    EXPECT_EQ(march(Point{}, to_the_right, just_near).queries, 1);
    EXPECT_FALSE(march(Point{}, to_the_right, just_not_near).hit);
}

TEST(RayMarcher, TheHundredthQueryIsAMiss)
{
    const March ray = march(Point{}, to_the_right, just_not_near);
    EXPECT_EQ(ray.queries, 100);
    EXPECT_FALSE(ray.hit);
    EXPECT_EQ(ray.point.x.raw(), 99 * surface_distance.raw()); // 0.99, no rounding on the way
}

TEST(RayMarcher, ExactlyTheMaximalDistanceIsNotBeyondIt)
{
    const March ray = march(Point{}, to_the_right, max_distance_away);
    EXPECT_FALSE(ray.hit);
    EXPECT_EQ(ray.queries, 2); // t = 20 goes on, t = 40 ends
}

TEST(RayMarcher, NearASurfaceBeyondTheMaximalDistanceIsAMiss)
{
    const March ray = march(Point{}, to_the_right, near_beyond_ten);
    EXPECT_FALSE(ray.hit); // d is small, but t = 20 + 2^-24
    EXPECT_EQ(ray.queries, 2);
}

TEST(Formats, ConstantsAreTheNearestRaws)
{
    EXPECT_EQ(surface_distance.raw(), 167'772); // 167772.16
    EXPECT_EQ(normal_step.raw(), 167'772);
    EXPECT_EQ(max_distance.raw(), 335'544'320);
    EXPECT_EQ(ratio(45, 100).raw(), 7'549'747);         // 7549747.2
    EXPECT_EQ(ratio(28'333, 100'000).raw(), 4'753'489); // 4753488.6
}

TEST(Formats, ProductsAreFloored)
{
    const auto raw_of = [](std::int64_t value) { return Coordinate::from_raw(value); };
    EXPECT_EQ(multiply(raw_of(3), raw_of(1 << 23)).raw(), 1);   // 1.5
    EXPECT_EQ(multiply(raw_of(-3), raw_of(1 << 23)).raw(), -2); // -1.5
    EXPECT_EQ(multiply(raw_of(-1), raw_of(1)).raw(), -1);
    EXPECT_EQ(multiply(unit, raw_of(-12345)).raw(), -12345);
}

} // namespace
} // namespace raymarch::engine::marcher
