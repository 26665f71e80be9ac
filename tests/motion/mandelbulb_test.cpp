// SPDX-License-Identifier: MIT
#include "motion/mandelbulb.hpp"

#include "engine/mandelbulb/distance.hpp"
#include "protocol/accelerators/mandelbulb.hpp"
#include "tests/engine/mandelbulb/views.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

namespace raymarch::motion::mandelbulb
{
namespace
{

using namespace engine::mandelbulb;
using Narrow = Q57<Int128>;

constexpr std::int64_t unit = std::int64_t{1} << 57;

/// Before the front of the set, 2.5 away from its middle.
World front()
{
    return enter(protocol::initial_state(protocol::mandelbulb::description));
}

std::int64_t distance(const Frame& frame)
{
    Arithmetic with = frame.arithmetic;
    with.scale = 0;
    return estimate<Narrow>(position_in<Narrow>(frame.position), with).distance;
}

double dot(const Direction& a, const Direction& b)
{
    const auto value = [](std::int64_t x, std::int64_t y) {
        return std::ldexp(static_cast<double>(x), -57) * std::ldexp(static_cast<double>(y), -57);
    };
    return value(a.x, b.x) + value(a.y, b.y) + value(a.z, b.z);
}

void expect_orthonormal(const Frame& frame)
{
    EXPECT_NEAR(dot(frame.forward, frame.forward), 1, 1e-15);
    EXPECT_NEAR(dot(frame.right, frame.right), 1, 1e-15);
    EXPECT_NEAR(dot(frame.up, frame.up), 1, 1e-15);
    EXPECT_NEAR(dot(frame.forward, frame.right), 0, 1e-15);
    EXPECT_NEAR(dot(frame.forward, frame.up), 0, 1e-15);
    EXPECT_NEAR(dot(frame.right, frame.up), 0, 1e-15);
}

TEST(MandelbulbMotion, NothingAskedNothingMoves)
{
    EXPECT_EQ(step(front(), {}), front());
    EXPECT_EQ(step(front(), Inputs(Input::Forward) | Input::Back), front());
}

TEST(MandelbulbMotion, ForwardIsAQuarterOfTheDistance)
{
    const World before = front(); // forward is +y
    const World after = step(before, Input::Forward);
    EXPECT_TRUE(after.frame.position.y - before.frame.position.y ==
                Int128(distance(before.frame) >> 2) << 7);
    EXPECT_TRUE(after.frame.position.x == 0);
    EXPECT_LT(distance(after.frame), distance(before.frame));
}

TEST(MandelbulbMotion, BackTakesTheSameWayAndStopsAtFour)
{
    World world = front();
    const World back = step(world, Input::Back);
    EXPECT_TRUE(world.frame.position.y - back.frame.position.y == Int128(distance(world.frame) >> 2)
                                                                      << 7);
    for (int i = 0; i < 100; ++i)
        world = step(world, Input::Back);
    EXPECT_TRUE(world.frame.position.y >= -(Int128(4) << 64));
    EXPECT_TRUE(world.frame.position.y < -(Int128(3) << 64));
}

TEST(MandelbulbMotion, ForwardNeverEntersTheSet)
{
    World world = front();
    for (int i = 0; i < 300; ++i) {
        world = step(world, Input::Forward);
        ASSERT_GT(distance(world.frame), 0) << i;
    }
    EXPECT_LT(distance(world.frame), unit >> 16);
}

TEST(MandelbulbMotion, BackLeadsOutOfTheSet)
{
    World world = front();
    world.frame.position.y = -Int128(unit); // 2^-7 from the middle
    ASSERT_EQ(distance(world.frame), 0);
    EXPECT_EQ(step(world, Input::Forward), world);
    for (int i = 0; i < 100; ++i)
        world = step(world, Input::Back);
    EXPECT_GT(distance(world.frame), 0);
}

TEST(MandelbulbMotion, SidewaysAndBack)
{
    const World right = step(front(), Input::StrafeRight);
    EXPECT_TRUE(right.frame.position.x > 0);
    EXPECT_TRUE(step(front(), Input::StrafeLeft).frame.position.x == -right.frame.position.x);
    const World up = step(front(), Input::Up);
    EXPECT_TRUE(up.frame.position.z == right.frame.position.x);
    EXPECT_TRUE(step(front(), Input::Down).frame.position.z == -up.frame.position.z);
}

TEST(MandelbulbMotion, TurnsAreDegrees)
{
    const double degree = std::acos(-1.0) / 180;
    // The axes of before that the new forward, or right, has turned towards.
    const Frame before = front().frame;
    const auto after = [](Input input) { return step(front(), input).frame; };
    EXPECT_NEAR(dot(after(Input::TurnRight).forward, before.right), std::sin(degree), 1e-15);
    EXPECT_NEAR(dot(after(Input::TurnLeft).forward, before.right), -std::sin(degree), 1e-15);
    EXPECT_NEAR(dot(after(Input::TurnUp).forward, before.up), std::sin(degree), 1e-15);
    EXPECT_NEAR(dot(after(Input::TurnDown).forward, before.up), -std::sin(degree), 1e-15);
    EXPECT_NEAR(dot(after(Input::RollRight).up, before.right), std::sin(degree), 1e-15);
    EXPECT_NEAR(dot(after(Input::RollLeft).up, before.right), -std::sin(degree), 1e-15);

    World world = front();
    for (int i = 0; i < 360; ++i)
        world = step(world, Inputs(Input::TurnRight) | Input::RollLeft | Input::TurnUp);
    expect_orthonormal(world.frame);
    for (int i = 0; i < 360; ++i) // a whole turn ends where it began
        world = step(world, Input::TurnLeft);
    const World again = world;
    for (int i = 0; i < 360; ++i)
        world = step(world, Input::TurnLeft);
    EXPECT_NEAR(dot(world.frame.forward, again.frame.forward), 1, 1e-12);
}

TEST(MandelbulbMotion, AnimateDivesUntilTheStepsAreUsedUp)
{
    World world = front();
    for (int i = 0; i < 2000; ++i)
        world = step(world, Input::Animate);
    expect_orthonormal(world.frame);
    const std::int64_t d = distance(world.frame);
    EXPECT_GT(d, std::int64_t{720} << (57 - 30)); // z = 29 for 32 steps
    EXPECT_LT(d, std::int64_t{720} << (57 - 28));
    EXPECT_TRUE(step(world, Input::Animate).frame.position == world.frame.position);
}

TEST(MandelbulbMotion, TheScaleFollowsTheDepth)
{
    EXPECT_EQ(scale_at(Form::Q8_57, 44), 0);
    EXPECT_EQ(scale_at(Form::Q8_57, 54), 42);
    EXPECT_EQ(scale_at(Form::Q8_64, 51), 0);
    EXPECT_EQ(scale_at(Form::Q8_64, 58), 46);
    World world{read_views().back().frame}; // z = 54
    world.frame.arithmetic.steps = 57;
    world.frame.arithmetic.kept_bits = automatic_kept_bits(57);
    world = step(world, Input::Back);
    EXPECT_GE(world.frame.arithmetic.scale, 42);
    for (int i = 0; i < 400 && world.frame.arithmetic.scale != 0; ++i)
        world = step(world, Input::Back);
    EXPECT_EQ(world.frame.arithmetic.scale, 0);
}

TEST(MandelbulbMotion, ApproachFindsThePositionsOfTheVectors)
{
    // Target A: the ray of pixel (606, 229) of the whole, whose views stand on the same grids.
    const std::vector<View> views = read_views();
    for (const View& view : views) {
        if (view.name == "whole")
            continue;
        const int zoom = std::stoi(view.name.substr(view.name.find('z') + 1));
        const auto near = approach(views.front().frame, {1280, 720}, 606, 229, zoom);
        ASSERT_TRUE(near) << view.name;
        EXPECT_TRUE(near->position == view.frame.position) << view.name;
        EXPECT_NEAR(dot(near->forward, view.frame.forward), 1, 1e-15);
        EXPECT_EQ(near->arithmetic.scale, scale_at(Form::Q8_57, zoom));
        expect_orthonormal(*near);
    }
}

TEST(MandelbulbMotion, ApproachOfTheBackgroundFindsNothing)
{
    EXPECT_FALSE(approach(front().frame, {1280, 720}, 0, 0, 12));
}

TEST(MandelbulbMotion, TheStateOfAnApproachHasItsFrame)
{
    const protocol::State state = protocol::initial_state(protocol::mandelbulb::description);
    const auto frame = approach(front().frame, {1280, 720}, 640, 360, 12);
    const auto near = state_near(state, 640, 360, 12);
    ASSERT_TRUE(frame && near);
    EXPECT_EQ(enter(*near), World{*frame});
    EXPECT_FALSE(state_near(state, 0, 0, 12));
}

TEST(MandelbulbMotion, LeaveWritesWhatEnterReads)
{
    using namespace protocol::mandelbulb;
    protocol::State state = protocol::initial_state(description);
    state.codes[K] = 40;
    state.codes[FORM] = 1;
    World world = enter(state);
    EXPECT_EQ(world.frame.form, Form::Q8_64);
    for (const Input input : {Input::Forward, Input::StrafeLeft, Input::TurnUp, Input::RollLeft})
        world = step(world, input);
    leave(world, state);
    EXPECT_EQ(enter(state), world);
    EXPECT_EQ(state.codes[K], 40);
}

} // namespace
} // namespace raymarch::motion::mandelbulb
