// SPDX-License-Identifier: MIT
#include "motion/whitted.hpp"

#include "protocol/accelerators.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace raymarch::motion::whitted
{
namespace
{

Inputs both(Inputs a, Inputs b)
{
    return a | b;
}

constexpr float format_step = 1.0F / 4096;

float squared(const Point& v)
{
    return v.x * v.x + v.y * v.y + v.z * v.z;
}

World with_balls(std::initializer_list<Ball> balls, Rules rules = Rules::Repaired)
{
    World world{.count = balls.size(), .rules = rules};
    std::copy(balls.begin(), balls.end(), world.balls.begin());
    return world;
}

World steps(World world, Inputs inputs, int count)
{
    for (int i = 0; i < count; ++i)
        world = step(world, inputs);
    return world;
}

TEST(WhittedMotion, NothingMovesUnasked)
{
    const World world = with_balls({{.centre = {1, 2, 3}, .velocity = {1, 1, 1}, .radius = 2}});
    EXPECT_EQ(step(world, {}), world);
}

TEST(WhittedMotion, TheEyeMovesByOne)
{
    struct Row
    {
        Input input;
        Point to;
    };
    for (const Row& row :
         {Row{Input::Forward, {0, 0, -31}}, Row{Input::Back, {0, 0, -33}},
          Row{Input::StrafeLeft, {-1, 0, -32}}, Row{Input::StrafeRight, {1, 0, -32}},
          Row{Input::Up, {0, -1, -32}}, Row{Input::Down, {0, 1, -32}}})
        EXPECT_EQ(step({}, row.input).eye, row.to) << static_cast<int>(row.input);
    EXPECT_EQ(step({}, both(Input::Forward, Input::Back)), World{});
}

TEST(WhittedMotion, TheScreenMovesByASixteenth)
{
    EXPECT_EQ(step({}, Input::Narrow).screen, 8.0625F);
    EXPECT_EQ(step({}, Input::Widen).screen, 7.9375F);
    EXPECT_EQ(step({}, both(Input::Widen, Input::Narrow)).screen, 8);
    EXPECT_EQ(steps({}, Input::Widen, 500).screen, 0.0625F);
}

TEST(WhittedMotion, AWallPutsTheBallBackAndTakesSpeed)
{
    const World world = with_balls({{.centre = {28, 0, 0}, .velocity = {2, 1, -1}, .radius = 3}});
    const Ball ball = step(world, Input::Animate).balls[0];
    EXPECT_EQ(ball.velocity, (Point{-2 * 0.995F, 0.995F, -0.995F}));
    EXPECT_EQ(ball.centre.x, 27 - 2 * 0.995F);
    EXPECT_EQ(ball.centre.y, 0.995F);
}

TEST(WhittedMotion, ACornerIsAWallForEachAxis)
{
    const World world =
        with_balls({{.centre = {-29, 29, 29}, .velocity = {-1, 1, 1}, .radius = 3}});
    const Ball ball = step(world, Input::Animate).balls[0];
    const float kept = 0.995F * 0.995F * 0.995F;
    EXPECT_NEAR(ball.velocity.x, kept, 1e-6);
    EXPECT_NEAR(ball.velocity.y, -kept, 1e-6);
    EXPECT_NEAR(ball.velocity.z, -kept, 1e-6);
}

TEST(WhittedMotion, EachWallTakesOnePercentOfTheEnergy)
{
    World world = with_balls({{.centre = {0, 0, 0}, .velocity = {0.5F, 0, 0}, .radius = 3}});
    int hits = 0;
    for (int i = 0; i < 1000; ++i) {
        const float before = world.balls[0].velocity.x;
        world = step(world, Input::Animate);
        const float after = world.balls[0].velocity.x;
        if (before != after) {
            ++hits;
            EXPECT_EQ(after, -before * 0.995F);
        }
        EXPECT_LE(std::abs(world.balls[0].centre.x), 27 + 0.5F);
    }
    EXPECT_GE(hits, 8); // 54 units at about 0.5 a step
    EXPECT_NEAR(squared(world.balls[0].velocity), 0.25F * std::pow(0.995F * 0.995F, hits), 1e-4);
}

TEST(WhittedMotion, TheOriginalHasOddWallsOfZ)
{
    const auto after = [](float z) {
        const Ball ball{.centre = {0, 0, z}, .velocity = {0, 0, 1}, .radius = 3};
        return step(with_balls({ball}, Rules::Original), Input::Animate).balls[0];
    };
    EXPECT_EQ(after(-10).centre.z, -9); // -13 to -7: between -16 and -5
    EXPECT_EQ(after(-8).centre.z, 27 - 0.995F);
    EXPECT_EQ(after(-8).velocity.z, -0.995F);
    EXPECT_EQ(after(-14).centre.z, -27 - 0.995F);
}

/// Two balls that touch, about to collide at an angle in space.
World touching(Rules rules)
{
    return with_balls({{.centre = {0, 0, -10}, .velocity = {0.3F, 0.2F, -0.1F}, .radius = 2},
                       {.centre = {1.5F, 1, -11}, .velocity = {-0.1F, 0.05F, 0.2F}, .radius = 2}},
                      rules);
}

TEST(WhittedMotion, ACollisionKeepsMomentumAndEnergy)
{
    const World before = touching(Rules::Repaired);
    const World after = step(before, Input::Animate);
    const Point momentum = before.balls[0].velocity + before.balls[1].velocity;
    const Point kept = after.balls[0].velocity + after.balls[1].velocity;
    EXPECT_NEAR(momentum.x, kept.x, 1e-6);
    EXPECT_NEAR(momentum.y, kept.y, 1e-6);
    EXPECT_NEAR(momentum.z, kept.z, 1e-6);
    EXPECT_NEAR(squared(before.balls[0].velocity) + squared(before.balls[1].velocity),
                squared(after.balls[0].velocity) + squared(after.balls[1].velocity), 1e-6);
    EXPECT_NE(before.balls[0].velocity, after.balls[0].velocity);
    EXPECT_EQ(after.balls[0].rest, 10);
    EXPECT_EQ(after.balls[1].rest, 0);
}

TEST(WhittedMotion, TheOriginalsCollisionKeepsMomentumOnly)
{
    const World before = touching(Rules::Original);
    const World after = step(before, Input::Animate);
    const Point momentum = before.balls[0].velocity + before.balls[1].velocity;
    const Point kept = after.balls[0].velocity + after.balls[1].velocity;
    EXPECT_NEAR(momentum.x, kept.x, 1e-6);
    EXPECT_NEAR(momentum.z, kept.z, 1e-6);
    EXPECT_LT(squared(after.balls[0].velocity) + squared(after.balls[1].velocity),
              squared(before.balls[0].velocity) + squared(before.balls[1].velocity) - 1e-3);
}

TEST(WhittedMotion, AlongAnAxisBothRulesExchangeTheSpeeds)
{
    for (const Rules rules : {Rules::Original, Rules::Repaired}) {
        const World world =
            with_balls({{.centre = {-2, 0, -10}, .velocity = {1, 0, 0}, .radius = 2},
                        {.centre = {2, 0, -10}, .velocity = {-0.5F, 0, 0}, .radius = 2}},
                       rules);
        const World after = step(world, Input::Animate);
        EXPECT_EQ(after.balls[0].velocity, (Point{-0.5F, 0, 0}));
        EXPECT_EQ(after.balls[1].velocity, (Point{1, 0, 0}));
    }
}

TEST(WhittedMotion, PartingBallsAreLeftAlone)
{
    World world = touching(Rules::Repaired);
    for (Ball& ball : world.balls)
        ball.velocity = engine::map(ball.velocity, [](float c) { return -c; });
    const World after = step(world, Input::Animate);
    EXPECT_EQ(after.balls[0].velocity, world.balls[0].velocity);
    EXPECT_EQ(after.balls[0].rest, 0);
}

TEST(WhittedMotion, BallsOfOneCentreHaveNoNormal)
{
    for (const Rules rules : {Rules::Original, Rules::Repaired}) {
        const World world = with_balls(
            {{.centre = {0, 0, -10}}, {.centre = {0, 0, -10}, .velocity = {0, 1, 0}}}, rules);
        EXPECT_EQ(step(world, Input::Animate).balls[1].velocity, (Point{0, 1, 0}));
    }
}

TEST(WhittedMotion, TheRestDependsOnTheSpeedLeft)
{
    const auto rest = [](float left) {
        const World world =
            with_balls({{.centre = {-2, 0, 0}, .velocity = {1, 0, 0}, .radius = 2},
                        {.centre = {2, 0, 0}, .velocity = {left, 0, 0}, .radius = 2}});
        return step(world, Input::Animate).balls[0].rest;
    };
    EXPECT_EQ(rest(0), 100);
    EXPECT_EQ(rest(0.0005F), 50);
    EXPECT_EQ(rest(-0.01F), 10);
}

TEST(WhittedMotion, ARestIsCountedInCallsOrInOtherBalls)
{
    for (const Rules rules : {Rules::Original, Rules::Repaired}) {
        const Ball far{.centre = {20, 20, -10}};
        World world =
            with_balls({{.centre = {0, 0, -10}, .rest = 7}, far, {.centre = {-20, 0, -10}}}, rules);
        world = step(world, Input::Animate);
        EXPECT_EQ(world.balls[0].rest, rules == Rules::Original ? 5 : 6);
        world = steps(world, Input::Animate, 10);
        EXPECT_EQ(world.balls[0].rest, 0);
    }
}

TEST(WhittedMotion, AClosedBoxNeverGainsEnergy)
{
    World world = with_balls({{.centre = {0, 0, 0}, .velocity = {0.9F, 0.4F, -0.7F}, .radius = 4},
                              {.centre = {15, 3, 2}, .velocity = {-0.5F, 0.1F, 0.3F}, .radius = 3},
                              {.centre = {-15, -3, 9}, .velocity = {0.2F, -0.8F, 0}, .radius = 5},
                              {.centre = {3, 18, -9}, .velocity = {0, -1, 0.1F}, .radius = 2}});
    const auto energy = [&] {
        float sum = 0;
        for (const Ball& ball : world.balls)
            sum += squared(ball.velocity);
        return sum;
    };
    float before = energy();
    const float first = before;
    for (int i = 0; i < 2000; ++i) {
        world = step(world, Input::Animate);
        ASSERT_LE(energy(), before + 1e-5F) << "step " << i;
        before = energy();
        for (std::size_t k = 0; k < world.count; ++k)
            ASSERT_LT(squared(world.balls[k].centre), 3 * 32 * 32) << "step " << i;
    }
    EXPECT_LT(before, first);
    EXPECT_GT(before, 0);
}

constexpr std::array turn_pairs = {std::array{Input::TurnLeft, Input::TurnRight},
                                   std::array{Input::TurnUp, Input::TurnDown},
                                   std::array{Input::RollLeft, Input::RollRight}};

TEST(WhittedMotion, TurningForthAndBackReturns)
{
    const World world = with_balls({{.centre = {15, -7, 30}}, {.centre = {-21, 3.5F, 1}}});
    for (const auto& [forth, back] : turn_pairs) {
        const World away = steps(world, forth, 50);
        const World home = steps(away, back, 50);
        for (std::size_t i = 0; i < world.count; ++i) {
            EXPECT_GT(squared(away.balls[i].centre - world.balls[i].centre), 1);
            EXPECT_LT(squared(home.balls[i].centre - world.balls[i].centre),
                      format_step * format_step);
        }
    }
}

TEST(WhittedMotion, AFullTurnReturns)
{
    const World world = with_balls({{.centre = {15, -7, 30}}});
    for (const auto& pair : turn_pairs)
        for (const Input input : pair) {
            const Point start = world.balls[0].centre;
            const Point end = steps(world, input, 209).balls[0].centre;
            const float radius = std::sqrt(squared(start));
            EXPECT_NEAR(std::sqrt(squared(end)), radius, format_step);
            // What is left of the turn: 2 pi - 209 * 0.03 = 0.013185 rad.
            EXPECT_LT(std::sqrt(squared(end - start)), 0.0133F * radius);
            EXPECT_LT(
                squared(
                    step(World{.balls = {Ball{.centre = end}}, .count = 1}, input).balls[0].centre -
                    start),
                0.0169F * 0.0169F * squared(start));
        }
}

TEST(WhittedMotion, TheOriginalShrinksTheScene)
{
    // The area that two balls span with the origin, in the plane of the turn.
    const auto area = [](const World& world) {
        const Point& a = world.balls[0].centre;
        const Point& b = world.balls[1].centre;
        return a.x * b.y - a.y * b.x;
    };
    const auto world = [](Rules rules) {
        return with_balls({{.centre = {20, 3, 5}}, {.centre = {-2, 20, 5}}}, rules);
    };
    const float cosine = std::cos(0.03F);
    const float shrunk = std::pow(cosine * cosine, 100.0F);
    const float original = area(steps(world(Rules::Original), Input::RollRight, 100));
    EXPECT_NEAR(original / area(world(Rules::Original)), shrunk, 1e-4);
    const float repaired = area(steps(world(Rules::Repaired), Input::RollRight, 100));
    EXPECT_NEAR(repaired / area(world(Rules::Repaired)), 1, 1e-4);
}

TEST(WhittedMotion, ClockwiseAboutZ)
{
    const World world = with_balls({{.centre = {1, 0, 0}, .velocity = {1, 0, 0}}});
    const Ball ball = step(world, Input::RollRight).balls[0];
    EXPECT_NEAR(ball.centre.x, std::cos(0.03F), 1e-6);
    EXPECT_NEAR(ball.centre.y, -std::sin(0.03F), 1e-6);
    EXPECT_EQ(ball.velocity, (Point{1, 0, 0})); // is not turned
}

TEST(WhittedMotion, OnlyOneTurnAtATime)
{
    const World world = with_balls({{.centre = {1, 2, 3}}});
    EXPECT_EQ(step(world, both(Input::TurnLeft, Input::TurnRight)), world);
    EXPECT_EQ(step(world, both(Input::TurnLeft, Input::RollLeft)), world);
}

namespace table = protocol::whitted;

TEST(WhittedMotion, AStateIsEnteredAndLeftUnchanged)
{
    protocol::State state = protocol::initial_state(table::description);
    state.codes[table::N] = 14;
    state.codes[table::MOTION] = 0;
    const protocol::State before = state;
    const World world = enter(state);
    EXPECT_EQ(world.count, 14U);
    EXPECT_EQ(world.rules, Rules::Original);
    EXPECT_EQ(world.eye, (Point{0, 0, -32}));
    EXPECT_EQ(world.screen, 8);
    EXPECT_EQ(world.box.low, (Point{-26, -30, -16}));
    EXPECT_EQ(world.box.high, (Point{26, 22, 40}));
    EXPECT_EQ(world.balls[13].centre, (Point{0, 18, -10}));
    EXPECT_EQ(world.balls[13].velocity, (Point{0.1875F, -0.5F, 0.125F}));
    EXPECT_EQ(world.balls[13].radius, 3);
    leave(world, state);
    EXPECT_EQ(state, before);
}

TEST(WhittedMotion, ValuesAreTruncatedAndStayInTheirRanges)
{
    protocol::State state = protocol::initial_state(table::description);
    World world = enter(state);
    world.eye = {-1.9999F / 4096, 1.9999F / 4096, -5000};
    world.screen = 100;
    leave(world, state);
    EXPECT_EQ(state.codes[table::EX], -1);
    EXPECT_EQ(state.codes[table::EY], 1);
    EXPECT_EQ(state.codes[table::EZ], -1024 * 4096);
    EXPECT_EQ(state.codes[table::S], 63 * 4096);
}

} // namespace
} // namespace raymarch::motion::whitted
