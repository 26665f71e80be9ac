// SPDX-License-Identifier: MIT
#include "engine/marcher/surface_vectors.hpp"

#include <gtest/gtest.h>

namespace raymarch::engine::marcher
{
namespace
{

constexpr int scale = 1 << 24;

void expect_near(const Point& p, double x, double y, double z, int tolerance)
{
    EXPECT_NEAR(p.x.raw(), x * scale, tolerance);
    EXPECT_NEAR(p.y.raw(), y * scale, tolerance);
    EXPECT_NEAR(p.z.raw(), z * scale, tolerance);
}

constexpr Coordinate none{};

TEST(SurfaceNormal, OfTheFacesOfACube)
{
    // Inside a face the taps differ by h along one axis only.
    expect_near(surface_normal({ratio(1, 2), none, none}, cube), 1, 0, 0, 1);
    expect_near(surface_normal({ratio(-1, 2), none, none}, cube), -1, 0, 0, 1);
    expect_near(surface_normal({none, ratio(1, 2), none}, cube), 0, 1, 0, 1);
    expect_near(surface_normal({none, none, ratio(-1, 2)}, cube), 0, 0, -1, 1);
}

TEST(SurfaceNormal, OfASpherePointsOutwards)
{
    // The taps see the curvature: an error of h * |xy| on the third axis, so at most h / 2.
    expect_near(surface_normal({none, none, ratio(1, 1)}, sphere), 0, 0, 1, 2000);
    expect_near(surface_normal({ratio(-3, 5), ratio(4, 5), none}, sphere), -0.6, 0.8, 0,
                normal_step.raw() / 2);
}

Coordinate constant(const Point& /*p*/) noexcept
{
    return ratio(1, 1);
}

TEST(SurfaceNormal, IsZeroWhereTheTapsCancel)
{
    EXPECT_EQ(surface_normal(Point{}, constant), Point{});
}

TEST(LightDirection, PointsToTheLight)
{
    expect_near(light_direction(Point{}, {ratio(3, 1), ratio(4, 1), none}), 0.6, 0.8, 0, 2);
    expect_near(light_direction({none, none, ratio(20, 1)}, {none, none, ratio(-64, 1)}), 0, 0, -1,
                1);
    EXPECT_EQ(light_direction({ratio(1, 1), none, none}, {ratio(1, 1), none, none}), Point{});
}

} // namespace
} // namespace raymarch::engine::marcher
