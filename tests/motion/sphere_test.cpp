// SPDX-License-Identifier: MIT
#include "motion/sphere.hpp"

#include "protocol/accelerators/sphere.hpp"

#include <gtest/gtest.h>

#include <array>
#include <utility>

namespace raymarch::motion::sphere
{
namespace
{

World after(World world, Inputs inputs, int steps = 1)
{
    for (int i = 0; i < steps; ++i)
        world = step(world, inputs);
    return world;
}

TEST(SphereMotion, TheDemosSphere)
{
    const World power_up;
    EXPECT_EQ(after(power_up, Input::Animate).ball_x, 325); // the first frame's
    EXPECT_EQ(after(power_up, Input::Animate, 2).ball_x, 330);
    EXPECT_EQ(after(power_up, Input::Animate, 44).ball_x, 540);
    EXPECT_EQ(after(power_up, Input::Animate, 45).ball_x, 100);
    EXPECT_EQ(after(power_up, Input::Animate, 46).ball_x, 105);
}

TEST(SphereMotion, TheDemoRepeatsAfter89Frames)
{
    const World first = after({}, Input::Animate);
    World world = first;
    for (int frames = 1; frames < 89; ++frames) {
        world = step(world, Input::Animate);
        EXPECT_NE(world, first) << frames;
    }
    EXPECT_EQ(step(world, Input::Animate), first);
}

struct Row
{
    Inputs inputs;
    Point eye;
    int screen;
};

const std::array rows = {
    Row{{}, {320, 240, 500}, 1000},
    Row{Input::Forward, {320, 240, 510}, 1000},
    Row{Input::Back, {320, 240, 490}, 1000},
    Row{Input::StrafeLeft, {310, 240, 500}, 1000},
    Row{Input::StrafeRight, {330, 240, 500}, 1000},
    Row{Input::Up, {320, 230, 500}, 1000},
    Row{Input::Down, {320, 250, 500}, 1000},
    Row{Input::Widen, {320, 240, 500}, 990},
    Row{Input::Narrow, {320, 240, 500}, 1010},
    Row{Inputs(Input::Forward) | Input::Up, {320, 230, 510}, 1000},
    Row{Inputs(Input::Forward) | Input::Back, {320, 240, 500}, 1000},
    Row{Inputs(Input::TurnLeft) | Input::TurnRight, {320, 240, 500}, 1000},
    Row{Inputs(Input::TurnUp) | Input::RollLeft, {320, 240, 500}, 1000},
};

TEST(SphereMotion, TheCamera)
{
    for (std::size_t i = 0; i < rows.size(); ++i) {
        World world;
        world.eye.z = 500;
        const World next = step(world, rows[i].inputs);
        EXPECT_EQ(next.eye, rows[i].eye) << "row " << i;
        EXPECT_EQ(next.screen, rows[i].screen) << "row " << i;
        EXPECT_EQ(next.ball_x, world.ball_x) << "row " << i;
    }
}

TEST(SphereMotion, TheCameraStaysInRange)
{
    EXPECT_EQ(after({}, Input::Back).eye.z, 0);
    EXPECT_EQ(after({}, Input::Forward, 200).eye.z, 999); // before the screen plane
    EXPECT_EQ(after({}, Input::StrafeLeft, 100).eye.x, 0);
    EXPECT_EQ(after({}, Input::StrafeRight, 7'000).eye.x, 65'535);
    EXPECT_EQ(after({}, Input::Widen, 200).screen, 1);
    EXPECT_EQ(after({}, Input::Narrow, 7'000).screen, 65'535);

    World wide;
    wide.low = -65'536;
    EXPECT_EQ(after(wide, Input::Back, 10'000).eye.z, -65'536);

    World beyond; // as a host has set it
    beyond.eye.z = 2000;
    EXPECT_EQ(after(beyond, Input::Forward), beyond);
    EXPECT_EQ(after(beyond, Input::Back).eye.z, 1990);
}

namespace table = protocol::sphere;

TEST(SphereMotion, TheDefaultsArePowerUp)
{
    EXPECT_EQ(enter(protocol::initial_state(table::description)), World{});
}

TEST(SphereMotion, EntersAndLeaves)
{
    protocol::State state = protocol::initial_state(table::description);
    state.codes[table::S1] = 540;
    leave(step(enter(state), Inputs(Input::Animate) | Input::Forward | Input::Narrow), state);
    protocol::State expected = protocol::initial_state(table::description);
    expected.codes[table::S1] = 100;
    expected.codes[table::EZ] = 10;
    expected.codes[table::F] = 1010;
    EXPECT_EQ(state, expected);
}

TEST(SphereMotion, TheHardwaresRegistersHaveNoSign)
{
    protocol::State state = protocol::initial_state(table::description);
    state.codes[table::EX] = -1;
    EXPECT_EQ(enter(state).eye.x, 65'535);
    EXPECT_EQ(enter(state).low, 0);
    for (const auto& [key, value] : {std::pair{table::MODEL, 3}, std::pair{table::FAULTS, 2}}) {
        protocol::State other = state;
        other.codes[key] = value;
        EXPECT_EQ(enter(other).eye.x, -1);
        EXPECT_EQ(enter(other).low, -65'536);
        EXPECT_EQ(enter(other).high, 65'535);
    }
}

} // namespace
} // namespace raymarch::motion::sphere
