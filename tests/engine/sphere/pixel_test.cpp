// SPDX-License-Identifier: MIT
/// @file
/// The rules above the ray-sphere unit: what is visible, what is lit, how bright; kept and
/// corrected.
#include "engine/sphere/light_falloff.hpp"
#include "engine/sphere/prototype_pixel.hpp"
#include "engine/sphere/ray_sphere_unit.hpp"
#include "engine/sphere/rtl_pixel.hpp"
#include "tests/engine/sphere/drawing.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>

namespace raymarch::engine::sphere
{
namespace
{

using Colour = std::array<std::uint8_t, 3>;

static_assert(squared_distance({1, 2, 3}, {4, 6, 15}) == 9 + 16 + 144);
static_assert(squared_distance({INT32_MIN, 0, 0}, {0, 0, 0}) == std::uint64_t{1} << 62);
static_assert(falloff(7, 2) == 3 && falloff(-7, 2) == -3 && falloff(7, 0) == 0);
static_assert(falloff(INT64_MAX, UINT64_MAX) == 0);

/// A scene of the prototype that looks along z at spheres in a row.
Frame row_of_spheres(Faults faults)
{
    Frame frame = prototype_scene();
    frame.faults = faults;
    frame.ball_count = 3;
    frame.balls = {{{{320, 240, 900}, 20}, {{320, 240, 600}, 20}, {{320, 240, -600}, 20}}};
    frame.light_count = 1;
    frame.lights[0] = {{320, 240, 100}, 10'000'000};
    return frame;
}

TEST(SpherePrototype, TheNearestSphereShowsOnlyWhenCorrected)
{
    // Kept: the colour of the first, the point of the last that is hit, here the second's. It is
    // in the light: 750,000,000 / 474^2 or so is white.
    EXPECT_EQ(prototype_pixel(row_of_spheres(Faults::Kept), 320, 240).colour,
              (Colour{255, 25, 25}));
    EXPECT_EQ(prototype_pixel(row_of_spheres(Faults::Corrected), 320, 240).colour,
              (Colour{25, 255, 25}));
}

TEST(SpherePrototype, CountsRaysAndEvaluations)
{
    const PrototypePixel hit = prototype_pixel(row_of_spheres(Faults::Kept), 320, 240);
    EXPECT_EQ(hit.rays, 2U);
    EXPECT_EQ(hit.evaluations, 6U);
    const PrototypePixel miss = prototype_pixel(row_of_spheres(Faults::Kept), 0, 0);
    EXPECT_EQ(miss.colour, (Colour{0, 0, 0}));
    EXPECT_EQ(miss.rays, 1U);
    EXPECT_EQ(miss.evaluations, 3U);
}

TEST(SpherePrototype, LightsAddUpToWhite)
{
    Frame frame = row_of_spheres(Faults::Corrected);
    frame.light_count = max_lights;
    frame.lights.fill({{320, 240, 100}, 100'000}); // 7,500,000 / 475^2 = 33
    const Point point{0, 0, 0};
    EXPECT_EQ(falloff(7'500'000, squared_distance(point, {0, 0, 475})), 33);
    const std::uint8_t one = [&] {
        Frame single = frame;
        single.light_count = 1;
        return prototype_pixel(single, 320, 240).colour[1];
    }();
    EXPECT_GT(one, 30);
    EXPECT_EQ(prototype_pixel(frame, 320, 240).colour[1], std::min(255, 8 * one));
    frame.light_count = 0;
    EXPECT_EQ(prototype_pixel(frame, 320, 240).colour, (Colour{25, 25, 25}));
    frame.ball_count = 0;
    EXPECT_EQ(prototype_pixel(frame, 320, 240).colour, (Colour{0, 0, 0}));
}

TEST(SpherePrototype, AProductOf32BitsWrapsUnlessCorrected)
{
    Frame frame = row_of_spheres(Faults::Kept);
    frame.calibration = 1000;
    frame.lights[0].strength = 2'147'484; // 1000 times it is 2^31 + 352
    // (2^31 + 352 - 2^32) / 475^2 = -9518 or so, modulo 256.
    const Strike strike =
        intersect(rules_of(frame.design, frame.faults), {frame.eye, {320, 240, frame.screen}},
                  frame.balls[1], Reach::Ray, frame.derounder);
    const auto squared =
        static_cast<std::int64_t>(squared_distance(strike.point, frame.lights[0].position));
    const auto wrapped = static_cast<std::uint8_t>(-2'147'483'296 / squared);
    EXPECT_EQ(prototype_pixel(frame, 320, 240).colour[0], std::max<int>(wrapped, 25));
    frame.faults = Faults::Corrected;
    EXPECT_EQ(prototype_pixel(frame, 320, 240).colour[1], 255);
}

/// The hardware, looking along z at its sphere, the light between.
Frame lit_from_the_eye(Faults faults)
{
    Frame frame;
    frame.faults = faults;
    frame.lights[0] = {{320, 240, 500}, 1};
    return frame;
}

TEST(SphereRtl, ASphereBehindTheEyeIsDrawnOnlyWhenKept)
{
    for (const Faults faults : {Faults::Kept, Faults::Repaired, Faults::Corrected}) {
        Frame frame;
        frame.faults = faults;
        frame.eye.z = 2000;
        frame.screen = 2500;
        const RtlPixel pixel = rtl_pixel(frame, 320, 240);
        EXPECT_EQ(pixel.outcome == Outcome::Behind, faults != Faults::Kept);
        EXPECT_EQ(pixel.outcome == Outcome::Missed, false);
    }
}

TEST(SphereRtl, LitIsNeverDarkerThanShadowWhenCorrected)
{
    EXPECT_EQ(rtl_pixel(lit_from_the_eye(Faults::Kept), 320, 240).outcome, Outcome::Shadowed);
    const RtlPixel repaired = rtl_pixel(lit_from_the_eye(Faults::Repaired), 320, 240);
    EXPECT_EQ(repaired.outcome, Outcome::LitRejected);
    EXPECT_EQ(repaired.value, 0); // 200 / 493^2
    EXPECT_EQ(rtl_pixel(lit_from_the_eye(Faults::Corrected), 320, 240).value, 2);
}

TEST(SphereRtl, AtTheLightItselfItIsBrightWhenCorrected)
{
    for (const Faults faults : {Faults::Repaired, Faults::Corrected}) {
        Frame frame = lit_from_the_eye(faults);
        const Point point = rtl_pixel(frame, 320, 240).point;
        frame.lights[0].position = point;
        const RtlPixel pixel = rtl_pixel(frame, 320, 240);
        ASSERT_EQ(pixel.point, point);
        EXPECT_TRUE(row_of(pixel.outcome).lit); // a line of no length: no root is on the way
        EXPECT_EQ(pixel.value, faults == Faults::Corrected ? 15 : 0);
    }
}

TEST(SphereRtl, RegistersLoseTheUpperBits)
{
    Frame frame;
    frame.eye = {-1, 65'536 + 7, 0};
    frame.calibration = 1024 + 3;
    frame.shadow = 25;
    frame.balls[0] = {{-65'536, 70'000, 5}, 65'537};
    frame.lights[0].strength = 65'536 + 9;
    const Frame kept = held(frame);
    EXPECT_EQ(kept.eye, (Point{65'535, 7, 0}));
    EXPECT_EQ(kept.calibration, 3);
    EXPECT_EQ(kept.shadow, 9);
    EXPECT_EQ(kept.balls[0].centre, (Point{0, 4'464, 5}));
    EXPECT_EQ(kept.balls[0].radius, 1);
    EXPECT_EQ(kept.lights[0].strength, 9);
    frame.faults = Faults::Corrected;
    EXPECT_EQ(held(frame).eye, frame.eye);
    frame.faults = Faults::Kept;
    frame.design = Design::Prototype;
    EXPECT_EQ(held(frame).balls[0].radius, 65'537);
}

TEST(SphereRtl, TheTint)
{
    Frame frame = frame_a();
    for (const Tint tint : {Tint::Yellow, Tint::Grey}) {
        frame.tint = tint;
        const Drawing drawing = draw_frame(frame);
        for (std::size_t i = 0; i < drawing.image.rgb.size(); i += 3) {
            const auto& rgb = drawing.image.rgb;
            ASSERT_EQ(rgb[i] % 17, 0);
            ASSERT_EQ(rgb[i + 1], rgb[i]);
            ASSERT_EQ(rgb[i + 2], tint == Tint::Grey ? rgb[i] : 0);
        }
    }
}

TEST(SphereRtl, CorrectedHasNeitherShiftNorStaleQuotient)
{
    Frame frame = frame_a();
    frame.faults = Faults::Corrected;
    const Drawing plain = draw_frame(frame);
    for (const Design design : {Design::RtlTop, Design::RtlTimed}) {
        frame.design = design;
        EXPECT_EQ(draw_frame(frame).image.rgb, plain.image.rgb);
    }
}

} // namespace
} // namespace raymarch::engine::sphere
