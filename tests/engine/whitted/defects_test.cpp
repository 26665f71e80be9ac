// SPDX-License-Identifier: MIT
/// @file
/// Each defect of the original by itself, added to the repaired machine.
#include "engine/whitted/nearest_hit.hpp"
#include "engine/whitted/pixel.hpp"
#include "engine/whitted/ray_setup.hpp"
#include "engine/whitted/shadow.hpp"
#include "engine/whitted/tracer.hpp"
#include "engine/whitted/whitted.hpp"
#include "tests/engine/whitted/report.hpp"

#include <gtest/gtest.h>

namespace raymarch::engine::whitted
{
namespace
{

using test::at;

constexpr PictureSize small = {320, 240};

Sphere grey(const Vector& centre, std::uint16_t radius)
{
    return make_sphere(centre, radius, {16, 16, 16}, 0x800);
}

/// A frame with these spheres; the light is far behind the eye.
Frame with_spheres(const std::vector<Sphere>& spheres)
{
    Frame frame = test::reset_frame(Profile::Repaired);
    frame.light = at(0, 0, -100);
    test::set_spheres(frame, spheres, 1);
    return frame;
}

Frame with(Frame frame, Defect defect)
{
    frame.defects = frame.defects.with(defect);
    return frame;
}

/// A ray along z from the origin that something has reflected.
const Ray along_z{.origin = {}, .direction = at(0, 0, 1), .reflected = true};

TEST(WhittedDefects, AProfileIsASetOfThem)
{
    for (const DefectRow& row : defects) {
        EXPECT_EQ(Defects(Profile::Measured).has(row.defect), row.measured) << row.what;
        EXPECT_FALSE(Defects(Profile::Repaired).has(row.defect)) << row.what;
    }
}

TEST(WhittedDefects, R1AKeptPointHidesWhatIsBeforeIt)
{
    const Frame frame = with_spheres({grey(at(0, 0, 30), 5), grey(at(0, 0, 10), 2)});
    const Hit right = nearest_hit(frame, along_z);
    EXPECT_EQ(right.index, 1);
    EXPECT_EQ(test::raw(right.point), test::raw(at(0, 0, 8)));
    EXPECT_EQ(right.cycles, 2 * cycles::hit + cycles::behind + cycles::sphere_chosen);
    const Hit wrong = nearest_hit(with(frame, Defect::MovingOrigin), along_z);
    EXPECT_EQ(wrong.index, 0);
    EXPECT_EQ(test::raw(wrong.point), test::raw(at(0, 0, 25)));
    // A primary ray has the eye to begin from.
    Ray primary = along_z;
    primary.reflected = false;
    EXPECT_EQ(nearest_hit(with(frame, Defect::MovingOrigin), primary).index, 1);
}

TEST(WhittedDefects, R1ABoundedPlaneMovesTheOriginEvenIfItIsMissed)
{
    Frame frame = with_spheres({});
    frame.planes_drawn = true;
    for (Plane& plane : frame.planes)
        plane = {.normal = at(0, 0, 1), .offset = {}}; // seen from behind
    frame.planes[0] = {.normal = at(0, 0, -1), .offset = at(40, 0, 0).x, .bounded = true};
    frame.planes[1] = {.normal = at(0, 0, -1), .offset = at(30, 0, 0).x};
    const Hit right = nearest_hit(frame, along_z);
    EXPECT_EQ(right.index, 1);
    EXPECT_EQ(right.distance.raw(), 30 * 4096);
    EXPECT_EQ(right.cycles, cycles::behind + 2 * cycles::plane_met + 2 * cycles::plane_away);
    EXPECT_EQ(nearest_hit(with(frame, Defect::MovingOrigin), along_z).what, Hit::What::Nothing);
}

TEST(WhittedDefects, R2TheStaleSphereBlocksWithoutAShadow)
{
    const Frame frame = with_spheres({grey(at(0, 20, 10), 2)});
    const WayToLight way = way_to_light({}, at(0, 0, 15));
    EXPECT_FALSE(search_shadow(frame, {}, way, 0).blocked);
    const Frame measured = with(frame, Defect::ShadowDistance);
    const ShadowSearch far = search_shadow(measured, {}, way, 0);
    EXPECT_FALSE(far.blocked); // 500 - 2 > 225
    EXPECT_EQ(far.cycles, cycles::too_far + cycles::too_far_at_the_end);
    const WayToLight longer = way_to_light({}, at(0, 0, 30));
    EXPECT_TRUE(search_shadow(measured, {}, longer, 0).blocked);
    EXPECT_EQ(search_shadow(measured, {}, longer, 0).cycles, cycles::blocked_within);
    const ShadowSearch other = search_shadow(measured, {}, longer, no_sphere);
    EXPECT_FALSE(other.blocked);
    EXPECT_EQ(other.cycles, cycles::missed);
}

TEST(WhittedDefects, R2OnPlanesItIsSphere0UntilASphereIsHit)
{
    // The floor at x = 3; sphere 0 is off the way to the light, but before the point.
    Frame frame = with_spheres({grey(at(-30, 0, 20), 2)});
    frame.light = at(-30, -10, 0);
    test::set_spheres(frame, {grey(at(-20, 20, 0), 2)}, 1);
    frame.planes_drawn = true;
    const Vector down = at(0, 1, 0);
    frame.eye = at(3, 0, 5);
    const Sample lit = trace(frame, down);
    EXPECT_EQ(lit.colour[0], 29U * 32 * 4095 >> 12); // 3 and 5: a bright square
    const Frame stale = with(with(frame, Defect::StaleSphere), Defect::ShadowDistance);
    EXPECT_EQ(trace(stale, down).colour[0], 29U * 16 * 4095 >> 12);
}

TEST(WhittedDefects, R2AReflectedRaySkipsTheSphereItLeaves)
{
    Ray ray = along_z; // from within sphere 0, as a rounded point of its surface may be
    ray.leaves = 0;
    const Frame frame = with_spheres({grey(at(0, 0, 1), 5)});
    EXPECT_EQ(nearest_hit(frame, ray).what, Hit::What::Nothing);
    EXPECT_EQ(nearest_hit(with(frame, Defect::StaleSphere), ray).what, Hit::What::Sphere);
}

TEST(WhittedDefects, R3OnlyAPositiveDistanceIsAHit)
{
    const Frame frame = with_spheres({grey(at(0, 0, 5), 5)}); // its surface is at 0
    EXPECT_EQ(nearest_hit(frame, along_z).what, Hit::What::Nothing);
    const Hit hit = nearest_hit(with(frame, Defect::UnsignedDistance), along_z);
    EXPECT_EQ(hit.what, Hit::What::Sphere);
    EXPECT_EQ(hit.distance.raw(), 0);
}

TEST(WhittedDefects, R5SquaredLengthsTellTheDistanceOfTheLightWrongly)
{
    const Frame frame = with_spheres({grey(at(0, 0, 12), 3)});
    const auto blocked = [&](int light, const Frame& of) {
        return search_shadow(of, {}, way_to_light({}, at(0, 0, light)), no_sphere).blocked;
    };
    const Frame measured = with(frame, Defect::ShadowDistance);
    // The sphere begins at 9.
    EXPECT_FALSE(blocked(8, frame));
    EXPECT_FALSE(blocked(9, frame));
    EXPECT_TRUE(blocked(10, frame));
    EXPECT_TRUE(blocked(13, frame));
    EXPECT_FALSE(blocked(10, measured)); // 144 - 3 > 100
    EXPECT_TRUE(blocked(12, measured));
}

TEST(WhittedDefects, R6PixelsBeforeTheFirstAreFarAway)
{
    Frame frame = with_spheres({});
    constexpr SamplePlace left{-1, 0, 0};
    const Vector right = primary_direction(frame, small, 0, 120, left);
    EXPECT_LT(right.x.raw(), 0);
    frame = with(frame, Defect::UnsignedPixel);
    EXPECT_NE(primary_direction(frame, small, 0, 120, left), right);
    EXPECT_EQ(primary_direction(frame, small, 0, 120, {}),
              primary_direction(with_spheres({}), small, 0, 120, {}));
}

TEST(WhittedDefects, R6Row0IsBlackButNotFree)
{
    Frame frame = with_spheres({});
    frame.planes_drawn = true;
    for (Plane& plane : frame.planes) {
        plane = {.normal = at(0, 0, -1), .offset = at(40, 0, 0).x};
        plane.colour = ray_colour({31, 0, 0});
    }
    const Pixel right = draw_pixel(frame, small, 160, 0);
    const Pixel black = draw_pixel(with(frame, Defect::UnsignedPixel), small, 160, 0);
    EXPECT_EQ(right.word.channels[0], 30); // 992 * 4095 / 4096
    EXPECT_EQ(black.word, FrameWord{});
    EXPECT_EQ(black.cost, right.cost);
}

TEST(WhittedDefects, R7AnEyeBeforeZeroIsTheSameOneBehindItIsNot)
{
    const auto direction = [](int z, Frame frame) {
        frame.eye.z = Word::from_raw(z);
        return primary_direction(frame, small, 40, 50, {});
    };
    const Frame right = with_spheres({});
    const Frame wrong = with(right, Defect::UnsignedEye);
    for (const int z : {-32 * 4096, -1, -1000 * 4096})
        EXPECT_EQ(direction(z, right), direction(z, wrong)) << z;
    for (const int z : {0, 1, 32 * 4096})
        EXPECT_NE(direction(z, right), direction(z, wrong)) << z;
}

TEST(WhittedDefects, R8TheLightInAMirrorHasItsFlag)
{
    Frame frame = with_spheres({grey(at(0, 0, 30), 5)});
    frame.reflections = 1;
    const Pixel mirror = draw_pixel(frame, small, 160, 120);
    EXPECT_FALSE(mirror.word.light);
    EXPECT_TRUE(draw_pixel(with(frame, Defect::LastHitIsLight), small, 160, 120).word.light);
    EXPECT_EQ(mirror.cost.rays, 3U); // primary, shadow, reflected

    frame.eye = at(0, 0, -132);
    frame.anti_aliasing = AntiAliasing::Eight;
    const Pixel light = draw_pixel(frame, small, 160, 120);
    EXPECT_EQ(light.word, (FrameWord{true, {31, 31, 31}}));
    EXPECT_EQ(displayed(light.word), (std::array<std::uint8_t, 3>{255, 255, 255}));
}

TEST(WhittedDefects, R9OneMoreColumnAndRow)
{
    const Frame frame = with_spheres({});
    constexpr PictureSize tiny{3, 2};
    const std::vector<PixelCost> costs(6, PixelCost{.steps = 18, .rays = 1});
    // The light is behind the eye: 14 + 3 + 1 for each ray.
    EXPECT_EQ(frame_cost(frame, tiny, costs), (FrameCost{6 * 18 + 1, 6}));
    EXPECT_EQ(frame_cost(with(frame, Defect::ExtraPixels), tiny, costs),
              (FrameCost{12 * 18 + 1, 12}));
}

TEST(WhittedDefects, R10AnEyeInsideASphereSeesBlackInBothProfiles)
{
    for (const Profile profile : {Profile::Measured, Profile::Repaired}) {
        Frame frame = with_spheres({grey(at(0, 0, 30), 5), grey(at(0, 0, -30), 4)});
        frame.defects = Defects(profile);
        const Sample sample = trace(frame, at(0, 0, 1));
        EXPECT_EQ(sample.colour, Colour{});
        EXPECT_EQ(sample.cost, (PixelCost{.steps = 14 + 11 + 2 + 1, .rays = 1}));
    }
}

} // namespace
} // namespace raymarch::engine::whitted
