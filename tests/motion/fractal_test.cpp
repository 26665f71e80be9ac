// SPDX-License-Identifier: MIT
#include "motion/fractal.hpp"

#include "protocol/accelerators/fractal.hpp"
#include "tests/engine/fractal/vectors.hpp"
#include "tests/fakes/random.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace raymarch::motion::fractal
{
namespace
{

using engine::fractal::hundredth;
using engine::fractal::Number;
using engine::fractal::one;
using engine::fractal::Point;
using engine::fractal::Scene;
using engine::fractal::word;

Number distance(const World& world)
{
    return engine::fractal::scene_row(world.scene).distance(world.position);
}

/// A world with the camera outside all walls, and walls in reach.
World start_in(Scene scene, Collision collision)
{
    World world{.scene = scene, .collision = collision};
    if (scene == Scene::Cubes)
        world.position = {word(0), engine::fractal::half, word(0)}; // halfway between two cubes
    if (scene == Scene::Cube)
        world.position = {word(0), word(3 << 14), -word(3 << 14)}; // above an edge
    world.wanted = world.position;
    return world;
}

constexpr std::array scenes = {Scene::Menger, Scene::Cubes, Scene::Cube, Scene::Maze};

/// The keys of the hardware by bit.
constexpr std::array keys = {Input::StrafeRight, Input::StrafeLeft, Input::Down, Input::Up,
                             Input::TurnRight,   Input::TurnLeft,   Input::Back, Input::Forward};

Inputs inputs_of(unsigned bits)
{
    Inputs inputs;
    for (std::size_t i = 0; i < keys.size(); ++i)
        if ((bits >> i & 1) != 0)
            inputs = inputs | keys[i];
    return inputs;
}

TEST(FractalMotion, TheTraceOfTheHardware)
{
    World world;
    const auto rows = engine::fractal::test::read_table("walk.tsv");
    EXPECT_EQ(rows.size(), 399U);
    using engine::fractal::test::hex_word;
    for (const auto& row : rows) {
        world.scene = static_cast<Scene>(std::stoi(row.at("scene")));
        world =
            step(world, inputs_of(static_cast<unsigned>(std::stoul(row.at("keys"), nullptr, 16))));
        const Point position{hex_word(row.at("px")), hex_word(row.at("py")),
                             hex_word(row.at("pz"))};
        ASSERT_EQ(world.position, position) << "tick " << row.at("#tick");
        ASSERT_EQ(world.forward, (Point{hex_word(row.at("dx")), word(0), hex_word(row.at("dz"))}))
            << "tick " << row.at("#tick");
    }
}

/// Random inputs out of `mask`, held for a while each; the smallest distance that was reached.
Number wander(World world, unsigned mask, int steps)
{
    std::mt19937_64 random = raymarch::test::seeded_random();
    Number nearest = distance(world);
    Inputs held;
    for (int i = 0; i < steps; ++i) {
        if (i % 64 == 0)
            held = inputs_of(raymarch::test::pick(random, 0U, 255U) & mask);
        world = step(world, held);
        nearest = std::min(nearest, distance(world));
    }
    return nearest;
}

constexpr unsigned walking = 0xF0; ///< forward, back, turns
constexpr unsigned everything = 0xFF;

TEST(FractalMotion, WalkingAloneNeverEndsInAWall)
{
    for (const Scene scene : scenes)
        EXPECT_GT(wander(start_in(scene, Collision::Faithful), walking, 30'000), hundredth)
            << static_cast<int>(scene);
}

/// The smallest distance that holding any one set of inputs leads to.
Number nearest_by_holding(const World& start)
{
    Number nearest = distance(start);
    for (unsigned held = 0; held <= everything; ++held) {
        World world = start;
        for (int i = 0; i < 100; ++i) {
            world = step(world, inputs_of(held));
            nearest = std::min(nearest, distance(world));
        }
    }
    return nearest;
}

TEST(FractalMotion, FaithfulCollisionLeaks)
{
    for (const Scene scene : scenes)
        EXPECT_LT(nearest_by_holding(start_in(scene, Collision::Faithful)), Number{})
            << static_cast<int>(scene);
}

TEST(FractalMotion, ClosedNeverEndsInAWall)
{
    for (const Scene scene : scenes) {
        const World start = start_in(scene, Collision::Closed);
        EXPECT_GT(nearest_by_holding(start), hundredth) << static_cast<int>(scene);
        EXPECT_GT(wander(start, everything, 30'000), hundredth) << static_cast<int>(scene);
    }
}

/// Under the cube, a step below where up is refused.
World under_the_cube(Collision collision)
{
    World world{.scene = Scene::Cube, .collision = collision};
    world.position = {word(0), -engine::fractal::half - hundredth - word(500), word(0)};
    world.wanted = world.position;
    return world;
}

TEST(FractalMotion, UpPassesAtTheSecondAttemptOnlyWhereFaithful)
{
    World world = under_the_cube(Collision::Faithful);
    const Point start = world.position;
    world = step(world, Input::Up);
    EXPECT_EQ(world.position, start);
    EXPECT_TRUE(world.in_wall);
    world = step(world, Input::Up);
    EXPECT_EQ(world.position.y, start.y + word(512));

    world = under_the_cube(Collision::Closed);
    for (int i = 0; i < 10; ++i)
        world = step(world, Input::Up);
    EXPECT_EQ(world.position, start);
}

TEST(FractalMotion, StrafeAndForwardTogetherPassOnlyWhereFaithful)
{
    for (const Collision collision : {Collision::Faithful, Collision::Closed}) {
        World world{.scene = Scene::Cube, .collision = collision};
        world.position = {word(0), word(0), -engine::fractal::half - hundredth - word(100)};
        const std::int32_t oblique = 46341; // 45 degrees: strafing left goes ahead in z, too
        world.forward = {word(oblique), word(0), word(oblique)};
        world.wanted = world.position;
        for (int i = 0; i < 10; ++i)
            world = step(world, Inputs(Input::Forward) | Input::StrafeLeft);
        EXPECT_EQ(distance(world) < Number{}, collision == Collision::Faithful);
    }
}

TEST(FractalMotion, ExactlyAtTheLimitIsBlockedAndNotInTheWall)
{
    World world = under_the_cube(Collision::Faithful);
    world.position.y = -engine::fractal::half - hundredth - word(512);
    world = step(world, Input::Up);
    EXPECT_EQ(world.position.y, -engine::fractal::half - hundredth - word(512));
    EXPECT_FALSE(world.in_wall);
}

TEST(FractalMotion, WhoStandsInMatterGetsOut)
{
    for (const Collision collision : {Collision::Faithful, Collision::Closed}) {
        World world{.scene = Scene::Cube, .collision = collision};
        world.position = {word(1 << 14), word(0), word(0)}; // halfway to a face
        world.wanted = world.position;
        for (int i = 0; i < 400; ++i)
            world = step(world, Input::StrafeRight); // along x
        EXPECT_GT(distance(world), hundredth);
    }
}

TEST(FractalMotion, OpposingInputsCancelAndLeftWins)
{
    const World world;
    Inputs both;
    for (const Input input : {Input::Forward, Input::Back, Input::Up, Input::Down,
                              Input::StrafeLeft, Input::StrafeRight})
        both = both | input;
    World next = step(step(world, both), both);
    EXPECT_EQ(next, world);
    next = step(world, Inputs(Input::TurnLeft) | Input::TurnRight);
    EXPECT_EQ(next.forward, step(world, Input::TurnLeft).forward);
    EXPECT_LT(next.forward.x, Number{});
}

TEST(FractalMotion, EvenTicksWalkAndOddOnesStrafe)
{
    World world = step({}, Inputs(Input::Forward) | Input::StrafeRight);
    EXPECT_EQ(world.position, (Point{word(0), one, word(-98304 + 655)}));
    world = step(world, Inputs(Input::Forward) | Input::StrafeRight);
    EXPECT_EQ(world.position, (Point{word(655), one, word(-98304 + 655)}));
}

TEST(FractalMotion, AnimateTurnsTheHue)
{
    World world;
    for (int i = 0; i < 256; ++i) {
        EXPECT_EQ(world.hue, i);
        world = step(world, Input::Animate);
    }
    EXPECT_EQ(world.hue, 0);
    EXPECT_EQ(world, World{}); // 256 ticks are an even number, and nothing else moved
}

TEST(FractalMotion, TheDefaultsAreTheStateAfterReset)
{
    EXPECT_EQ(enter(protocol::initial_state(protocol::fractal::description)), World{});
}

TEST(FractalMotion, LeaveWritesWhatMoved)
{
    namespace table = protocol::fractal;
    protocol::State state = protocol::initial_state(table::description);
    state.codes[table::FY] = -5;
    state.codes[table::SCENE] = 3;
    state.codes[table::COLLISION] = 1;
    const World world = enter(state);
    EXPECT_EQ(world.scene, Scene::Maze);
    EXPECT_EQ(world.collision, Collision::Closed);
    const World moved =
        step(world, Inputs(Input::Forward) | Input::TurnRight | Input::Down | Input::Animate);
    protocol::State expected = state;
    expected.codes[table::Y] = 65536 - 512;
    expected.codes[table::Z] = -98304 + 655;
    expected.codes[table::FX] = 655;
    expected.codes[table::FZ] = 65532;
    expected.codes[table::HUE] = 1;
    leave(moved, state);
    EXPECT_EQ(state, expected);
}

// A tick is a linear map, a turn by atan(655 / 65532) that shortens by 1.1e-5, and two floored
// products a component, each of which loses less than a unit. The map never lengthens, so after n
// ticks the forward vector is within 2 * sqrt(2) * n units of the n-th power of the map; the losses
// turn with the vector and nearly cancel out over a full turn, so that much less is measured.
TEST(FractalMotion, AFullTurnReturns)
{
    constexpr int ticks = 629; // 2 pi / atan(655 / 65532), rounded up
    for (const Input input : {Input::TurnLeft, Input::TurnRight}) {
        World world;
        const double angle = std::atan2(655, 65532) * (input == Input::TurnLeft ? -1 : 1);
        const double length = std::hypot(655, 65532) / 65536;
        for (int n = 1; n <= ticks; ++n) {
            world = step(world, input);
            const double exact = 65536 * std::pow(length, n);
            const double off = std::hypot(world.forward.x.raw() - exact * std::sin(angle * n),
                                          world.forward.z.raw() - exact * std::cos(angle * n));
            ASSERT_LT(off, 2 * std::sqrt(2) * n);
            if (n == ticks) {
                EXPECT_LT(off, 112); // measured: 111.1 to the left and 104.0 to the right
            }
        }
        EXPECT_LE(std::abs(world.forward.x.raw()), 225); // 0.0034 rad: 628.65 ticks would be a turn
        EXPECT_GE(world.forward.z.raw(), 65'183);        // 0.54 % shorter
    }
}

} // namespace
} // namespace raymarch::motion::fractal
