// SPDX-License-Identifier: MIT
/// @file
/// The sphere, plane and shading stages, each against its table.
#include "engine/whitted/plane_stage.hpp"
#include "engine/whitted/shading.hpp"
#include "engine/whitted/sphere_stage.hpp"
#include "tests/engine/whitted/report.hpp"

#include <gtest/gtest.h>

namespace raymarch::engine::whitted
{
namespace
{

using test::number;
using test::read_table;
using test::vector_at;
using test::word;

Vector point_at(const Vector& from, const Vector& direction, Word distance)
{
    return from + scale(direction, distance);
}

std::string outcome(const Approach& to)
{
    if (to.from_inside)
        return "inside";
    if (to.behind)
        return "behind";
    return to.half_chord < Wide{} ? "miss" : "hit";
}

TEST(Whitted, SpheresOfTheTable)
{
    for (const test::Columns& row : read_table("sphere.tsv")) {
        const testing::ScopedTrace trace("sphere.tsv", 0, testing::PrintToString(row));
        const Vector from = vector_at(row, 0);
        const Vector direction = vector_at(row, 3);
        const Sphere sphere =
            make_sphere(vector_at(row, 6), static_cast<std::uint16_t>(number(row.at(9))), {}, 0);
        const Approach to = approach(from, direction, sphere);
        EXPECT_EQ(to.squared_distance.raw(), number(row.at(10)));
        EXPECT_EQ(to.along.raw(), number(row.at(11)));
        EXPECT_EQ(to.half_chord.raw(), number(row.at(12)));
        ASSERT_EQ(outcome(to), row.at(13));
        if (row.at(13) != "hit")
            continue;
        const Word distance = distance_to_surface(to);
        const Vector point = point_at(from, direction, distance);
        EXPECT_EQ(distance.raw(), number(row.at(14)));
        EXPECT_EQ(point, vector_at(row, 15));
        EXPECT_EQ(sphere_normal(sphere, point), vector_at(row, 18));
    }
}

TEST(Whitted, ARayFromInsideMeetsTheFarSide)
{
    const Sphere sphere = make_sphere(test::at(0, 0, 2), 5, {}, 0);
    const Approach to = approach({}, test::at(0, 0, 1), sphere);
    EXPECT_TRUE(to.from_inside);
    EXPECT_EQ(distance_to_surface(to).raw(), 7 * 4096);
}

TEST(Whitted, ARadiusOf1HasTheInverse1)
{
    EXPECT_EQ(make_sphere({}, 1, {}, 0).inverse_radius.raw(), 4096);
    EXPECT_EQ(make_sphere({}, 15, {}, 0).inverse_radius.raw(), 273);
    EXPECT_EQ(make_sphere({}, 2047, {}, 0).inverse_radius.raw(), 2);
}

TEST(Whitted, PlanesOfTheTable)
{
    const auto room = test::room();
    for (const test::Columns& row : read_table("plane.tsv")) {
        const testing::ScopedTrace trace("plane.tsv", 0, testing::PrintToString(row));
        const Vector from = vector_at(row, 0);
        const Vector direction = vector_at(row, 3);
        const Plane& plane = room.at(static_cast<std::size_t>(number(row.at(6))));
        const PlaneDistance to = plane_distance(from, direction, plane);
        EXPECT_EQ(to.speed.raw(), number(row.at(7)));
        EXPECT_EQ(to.height.raw(), number(row.at(8)));
        ASSERT_EQ(to.away, row.at(10) == "away");
        if (to.away)
            continue;
        EXPECT_EQ(to.distance.raw(), number(row.at(9)));
        ASSERT_EQ(counts(to.distance), row.at(10) == "hit");
        if (!counts(to.distance))
            continue;
        const Vector point = point_at(from, direction, to.distance);
        EXPECT_EQ(point, vector_at(row, 11));
        const int shift = static_cast<int>(number(row.at(14)));
        EXPECT_EQ(plane_colour(plane, point)[0], plane.colour[0] >> shift);
    }
}

TEST(Whitted, APlaneAQuarterAwayDoesNotCount)
{
    EXPECT_FALSE(counts(Word::from_raw(-1)));
    EXPECT_FALSE(counts(Word::from_raw(0x400)));
    EXPECT_TRUE(counts(Word::from_raw(0x401)));
}

TEST(Whitted, ABoundedPlaneEndsAtItsLimits)
{
    Plane plane;
    plane.limits = {3, 1, 4};
    const auto within = [&](int x, int y, int z) {
        return within_limits(plane, {Word::from_raw(x), Word::from_raw(y), Word::from_raw(z)});
    };
    EXPECT_TRUE(within(3 * 4096 - 1, -4095, 4095));
    EXPECT_TRUE(within(1 - 3 * 4096, 0, 4 * 4096 - 1));
    EXPECT_FALSE(within(3 * 4096, 0, 0));
    EXPECT_FALSE(within(-3 * 4096, 0, 0));
    EXPECT_FALSE(within(0, 4096, 0));
    EXPECT_FALSE(within(0, 0, -4 * 4096));
    EXPECT_FALSE(within(-(1 << 23), 0, 0)); // whose magnitude is no word
}

TEST(Whitted, CheckersAreAsWideBelowZero)
{
    Plane plane;
    plane.colour = {512, 256, 128};
    const auto dark = [&](double x, double z) {
        const auto raw = [](double c) { return Word::from_raw(static_cast<int>(c * 4096)); };
        const Colour colour = plane_colour(plane, {raw(x), {}, raw(z)});
        EXPECT_EQ(colour[1] * 2, colour[0]);
        return colour[0] == 128;
    };
    plane.checker = 1;
    EXPECT_FALSE(dark(0.5, 0.5));
    EXPECT_TRUE(dark(-0.5, 0.5));
    EXPECT_TRUE(dark(1.5, 0.5));
    EXPECT_FALSE(dark(-1.5, 0.5));
    plane.checker = 2; // squares of 2 units
    EXPECT_FALSE(dark(1.5, 0.5));
    EXPECT_TRUE(dark(2.5, 0.5));
    plane.checker = 0;
    EXPECT_FALSE(dark(2.5, 0.5));
}

TEST(Whitted, ShadesOfTheTable)
{
    for (const test::Columns& row : read_table("shade.tsv")) {
        const testing::ScopedTrace trace("shade.tsv", 0, testing::PrintToString(row));
        const auto small = [&](std::size_t i) {
            return static_cast<std::uint16_t>(number(row.at(i)));
        };
        const Colour base = {small(0), 0, small(0)};
        const Wide cosine = Wide::from_raw(number(row.at(1)));
        const auto lit = [&](Highlight highlight) {
            return cosine < Wide{} ? ambient(base)
                                   : lambert(base, cosine_weight(cosine, highlight));
        };
        EXPECT_EQ(lit(Highlight::Wraps)[0], number(row.at(4)));
        EXPECT_EQ(lit(Highlight::Held)[0], number(row.at(5)));
        EXPECT_EQ(lit(Highlight::Held)[1], 0);
        const Colour before = {small(3), 0, 0};
        EXPECT_EQ(accumulate(before, lit(Highlight::Held), small(2))[0], number(row.at(6)));
        EXPECT_EQ(reflected_weight(small(2), small(7)), number(row.at(8)));
    }
}

} // namespace
} // namespace raymarch::engine::whitted
