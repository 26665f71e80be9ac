// SPDX-License-Identifier: MIT
/// @file
/// The distances against their formulas in double.
#include "engine/marcher/scene_query.hpp"

#include "tests/fakes/random.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace raymarch::engine::marcher
{
namespace
{

constexpr double raw_unit = 0x1p-24;

double value(Coordinate c)
{
    return c.raw() * raw_unit;
}

Point point(double x, double y, double z)
{
    const auto coordinate = [](double c) {
        return Coordinate::from_raw(static_cast<std::int64_t>(std::lround(c / raw_unit)));
    };
    return {coordinate(x), coordinate(y), coordinate(z)};
}

Point random_point(std::mt19937_64& random, std::int32_t largest)
{
    const auto coordinate = [&] {
        return Coordinate::from_raw(test::pick(random, -largest, largest));
    };
    return {coordinate(), coordinate(), coordinate()};
}

double sphere_formula(double x, double y, double z)
{
    return std::hypot(x, y, z) - 1;
}

double cube_formula(double x, double y, double z)
{
    return std::max({std::fabs(x), std::fabs(y), std::fabs(z)}) - 0.5;
}

double infinite_cube_formula(double x, double y, double z)
{
    const auto from_nearest_cube = [](double c) { return c - std::floor(c + 0.5); };
    return cube_formula(from_nearest_cube(x), from_nearest_cube(y), from_nearest_cube(z)) + 0.25;
}

double bars_formula(double x, double y, double z, double cell, double bar)
{
    const auto folded = [cell](double c) {
        return std::fabs(c - cell * std::floor(c / cell) - cell / 2);
    };
    std::array<double, 3> sorted = {folded(x), folded(y), folded(z)};
    std::ranges::sort(sorted);
    return sorted[1] - bar;
}

double tunnel_formula(double x, double y, double z)
{
    return std::max({bars_formula(x, y, z, 2, 0.45), bars_formula(x, y, z, 1, 0.28333),
                     bars_formula(x, y, z, 0.5, 0.18167), bars_formula(x, y, z, 0.125, 0.05)});
}

struct SceneCase
{
    Scene scene;
    double (*formula)(double, double, double);
    double absolute; ///< tolerance in raws
    double relative; ///< and as a part of the length of the position
};

constexpr std::array cases = {
    SceneCase{Scene::Sphere, sphere_formula, 1.5, 0x1p-25}, // the inverse square root's
    SceneCase{Scene::Cube, cube_formula, 0, 0},             // exact
    SceneCase{Scene::InfiniteCube, infinite_cube_formula, 0, 0},
    SceneCase{Scene::Tunnel, tunnel_formula, 0.5001, 0}, // the bars' constants are rounded
};

TEST(SceneQuery, AgreesWithTheFormulas)
{
    auto random = test::seeded_random();
    for (const SceneCase& row : cases) {
        for (int i = 0; i < 50'000; ++i) {
            const Point p = random_point(random, 48 << 24);
            const double x = value(p.x);
            const double y = value(p.y);
            const double z = value(p.z);
            const double expected = row.formula(x, y, z);
            const double tolerance = row.absolute * raw_unit + row.relative * std::hypot(x, y, z);
            ASSERT_NEAR(value(scene_row(row.scene).distance(p)), expected, tolerance)
                << "scene " << static_cast<int>(row.scene) << " at " << x << ' ' << y << ' ' << z;
        }
    }
}

TEST(SceneQuery, NeverOverestimatesAStep)
{
    // |d(p) - d(q)| <= |p - q|: or a step of the marcher could jump through a surface.
    auto random = test::seeded_random();
    for (const SceneCase& row : cases) {
        for (int i = 0; i < 50'000; ++i) {
            const Point p = random_point(random, 24 << 24);
            const Point q = p + random_point(random, 1 << test::pick(random, 8, 26));
            const Point apart = q - p;
            const double distance = std::hypot(value(apart.x), value(apart.y), value(apart.z));
            const Distance query = scene_row(row.scene).distance;
            ASSERT_LE(std::fabs(value(query(p)) - value(query(q))), distance + 50 * raw_unit)
                << "scene " << static_cast<int>(row.scene);
        }
    }
}

TEST(SceneQuery, DistancesByHand)
{
    EXPECT_NEAR(value(sphere(point(0, 0, 3))), 2, 2 * raw_unit);
    EXPECT_NEAR(value(sphere(point(0, 0, 0))), -1, 0);
    EXPECT_NEAR(value(sphere(point(-2, 3, 6))), 6, 5 * raw_unit); // 2, 3, 6: length 7
    EXPECT_EQ(value(cube(point(0, 0, 0))), -0.5);
    EXPECT_EQ(value(cube(point(-0.75, 0.5, 0))), 0.25);
    EXPECT_EQ(value(infinite_cube(point(0, 0, 0))), -0.25);  // inside a cube
    EXPECT_EQ(value(infinite_cube(point(7, -3, 2))), -0.25); // inside another
    EXPECT_EQ(value(infinite_cube(point(0.5, 0, 0))), 0.25); // between two
    EXPECT_EQ(value(infinite_cube(point(-0.5, 0, 0))), 0.25);
    EXPECT_EQ(value(infinite_cube(point(-0.3125, 2, 5))), 0.0625);
}

TEST(SceneQuery, ScenesThatRepeatDoSoBelowZeroToo)
{
    auto random = test::seeded_random();
    for (int i = 0; i < 10'000; ++i) {
        const Point p = random_point(random, 8 << 24);
        const Point moved = p + point(-6, 4, 2); // multiples of both periods
        ASSERT_EQ(infinite_cube(p), infinite_cube(moved));
        ASSERT_EQ(tunnel(p), tunnel(moved));
    }
}

TEST(SceneQuery, EachSceneHasItsRow)
{
    constexpr std::array<int, 4> cycles = {5, 1, 2, 8}; // source 000, Table 7
    for (std::uint8_t i = 0; i < 4; ++i) {
        EXPECT_EQ(scene_row(static_cast<Scene>(i)).scene, static_cast<Scene>(i));
        EXPECT_EQ(scene_row(static_cast<Scene>(i)).clock_cycles, cycles[i]);
    }
}

} // namespace
} // namespace raymarch::engine::marcher
