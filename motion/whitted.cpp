// SPDX-License-Identifier: MIT
#include "motion/whitted.hpp"

#include "protocol/accelerators/whitted.hpp"

#include <algorithm>
#include <cmath>

namespace raymarch::motion::whitted
{
namespace
{

using Axis = float Point::*;
constexpr std::array axes = {&Point::x, &Point::y, &Point::z};

constexpr float kept_at_a_wall = 0.995F;

// Sine and cosine of 0.03 rad. They are constants, so that the result is the same with every
// C library.
constexpr float cosine = 0.99955003F;
constexpr float sine = 0.0299955F;

float dot(const Point& a, const Point& b) noexcept
{
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

Point scaled(const Point& v, float factor) noexcept
{
    return engine::map(v, [=](float c) { return c * factor; });
}

/// The position at which a ball touches a wall, and the position to which it is moved back.
struct Limits
{
    float touch;
    float reset;
};

void bounce(Ball& ball, Axis axis, float put_back_to) noexcept
{
    ball.velocity.*axis = -(ball.velocity.*axis);
    ball.centre.*axis = put_back_to;
    ball.velocity = scaled(ball.velocity, kept_at_a_wall);
}

void bounce_off_walls(Ball& ball, const World& world) noexcept
{
    for (const Axis axis : axes) {
        Limits low{world.box.low.*axis, world.box.low.*axis};
        Limits high{world.box.high.*axis, world.box.high.*axis};
        // The source's program tests for the walls of z at other positions than it moves the balls
        // to.
        if (world.rules == Rules::Original && axis == &Point::z) {
            low.touch = -16;
            high.touch = -5;
        }
        if (ball.centre.*axis - ball.radius <= low.touch)
            bounce(ball, axis, low.reset + ball.radius);
        if (ball.centre.*axis + ball.radius >= high.touch)
            bounce(ball, axis, high.reset - ball.radius);
    }
}

/// How many steps a ball rests after a collision. A slow ball takes longer to get away.
int rest_after(const Point& velocity) noexcept
{
    const float speed = std::sqrt(dot(velocity, velocity));
    return speed < 0.0001F ? 100 : speed < 0.001F ? 50 : 10;
}

/// The velocity that the first ball passes to the second. `normal` is the unit vector from the
/// second to the first.
Point exchanged(const Point& normal, const Point& approach, Rules rules) noexcept
{
    if (rules == Rules::Repaired)
        return scaled(normal, dot(normal, approach));
    // Each axis is computed by itself. This is a reflection only if the normal is along an axis.
    const auto on = [&](Axis axis) { return normal.*axis * (normal.*axis * approach.*axis); };
    return {on(&Point::x), on(&Point::y), on(&Point::z)};
}

void collide(Ball& ball, Ball& other, Rules rules) noexcept
{
    const Point between = ball.centre - other.centre;
    const float squared = dot(between, between);
    const float reach = ball.radius + other.radius;
    if (squared > reach * reach || squared == 0)
        return;
    const Point normal = scaled(between, 1 / std::sqrt(squared));
    const Point approach = ball.velocity - other.velocity;
    if (rules == Rules::Repaired && dot(normal, approach) >= 0)
        return; // the balls already move apart
    const Point given = exchanged(normal, approach, rules);
    ball.velocity = ball.velocity - given;
    other.velocity = other.velocity + given;
    ball.rest = rest_after(ball.velocity);
}

void collide_with_others(World& world, std::size_t i) noexcept
{
    Ball& ball = world.balls[i];
    // The report counts calls of this function; its program counts each ball that is met.
    const bool counts_balls = world.rules == Rules::Original;
    const bool resting = ball.rest > 0;
    for (std::size_t j = 0; j < world.count; ++j) {
        if (j == i)
            continue;
        if (ball.rest == 0)
            collide(ball, world.balls[j], world.rules);
        else if (counts_balls)
            --ball.rest;
    }
    if (!counts_balls && resting)
        --ball.rest;
}

void move_balls(World& world) noexcept
{
    for (std::size_t i = 0; i < world.count; ++i) {
        Ball& ball = world.balls[i];
        bounce_off_walls(ball, world);
        collide_with_others(world, i);
        ball.centre = ball.centre + ball.velocity;
    }
}

/// Turns the plane of two axes. `direction` is 1 for clockwise, -1 for counter-clockwise.
struct Turn
{
    Input input;
    Axis a;
    Axis b;
    float direction;
};
constexpr std::array turns = {
    Turn{Input::TurnLeft, &Point::x, &Point::z, -1},
    Turn{Input::TurnRight, &Point::x, &Point::z, 1},
    Turn{Input::TurnUp, &Point::y, &Point::z, -1},
    Turn{Input::TurnDown, &Point::y, &Point::z, 1},
    Turn{Input::RollLeft, &Point::x, &Point::y, -1},
    Turn{Input::RollRight, &Point::x, &Point::y, 1},
};

Point turned(Point p, const Turn& turn, Rules rules) noexcept
{
    const float s = turn.direction * sine;
    const float a = p.*turn.a;
    p.*turn.a = a * cosine + p.*turn.b * s;
    // The source's program uses the new a here already, so that the scene shrinks.
    p.*turn.b = -(rules == Rules::Original ? p.*turn.a : a) * s + p.*turn.b * cosine;
    return p;
}

/// Turns the positions of the balls. Their velocities stay as they are.
void turn_scene(World& world, Inputs inputs) noexcept
{
    const auto asked = [=](const Turn& turn) { return inputs.has(turn.input); };
    if (std::ranges::count_if(turns, asked) != 1)
        return;
    const Turn& turn = *std::ranges::find_if(turns, asked);
    for (std::size_t i = 0; i < world.count; ++i)
        world.balls[i].centre = turned(world.balls[i].centre, turn, world.rules);
}

/// Returns 1 or -1 for one of two opposite inputs, and 0 if both or neither are set.
float direction(Inputs inputs, Input forth, Input back) noexcept
{
    return static_cast<float>(inputs.has(forth) ? 1 : 0) -
           static_cast<float>(inputs.has(back) ? 1 : 0);
}

namespace table = protocol::whitted;
namespace sphere = table::sphere;

float value_of(const protocol::State& state, std::size_t index) noexcept
{
    return std::ldexp(static_cast<float>(state.codes[index]),
                      -table::parameters[index].format.fraction_bits);
}

void set_value(protocol::State& state, std::size_t index, float value) noexcept
{
    const protocol::Parameter& parameter = table::parameters[index];
    const auto least = static_cast<float>(parameter.min_scaled);
    const auto most = static_cast<float>(parameter.max_scaled);
    const float code = std::ldexp(value, parameter.format.fraction_bits);
    state.codes[index] = static_cast<std::int64_t>(std::clamp(code, least, most));
}

/// Reads three values of a state, given their indices.
struct PointOf
{
    std::size_t x, y, z;

    [[nodiscard]] Point get(const protocol::State& state) const noexcept
    {
        return {value_of(state, x), value_of(state, y), value_of(state, z)};
    }
    void set(protocol::State& state, const Point& p) const noexcept
    {
        set_value(state, x, p.x);
        set_value(state, y, p.y);
        set_value(state, z, p.z);
    }
};

constexpr PointOf eye{table::EX, table::EY, table::EZ};
constexpr PointOf low_walls{table::XMIN, table::YMIN, table::ZMIN};
constexpr PointOf high_walls{table::XMAX, table::YMAX, table::ZMAX};

PointOf centre(std::size_t ball) noexcept
{
    return {table::index_of(sphere::X, ball), table::index_of(sphere::Y, ball),
            table::index_of(sphere::Z, ball)};
}

PointOf velocity(std::size_t ball) noexcept
{
    return {table::index_of(sphere::VX, ball), table::index_of(sphere::VY, ball),
            table::index_of(sphere::VZ, ball)};
}

} // namespace

World step(const World& world, Inputs inputs) noexcept
{
    World next = world;
    if (inputs.has(Input::Animate))
        move_balls(next);
    turn_scene(next, inputs);
    // y grows downwards, z away from the eye.
    next.eye = next.eye + Point{direction(inputs, Input::StrafeRight, Input::StrafeLeft),
                                direction(inputs, Input::Down, Input::Up),
                                direction(inputs, Input::Forward, Input::Back)};
    constexpr float screen_step = 1.0F / 16;
    next.screen = std::max(
        next.screen + screen_step * direction(inputs, Input::Narrow, Input::Widen), screen_step);
    return next;
}

World enter(const protocol::State& state) noexcept
{
    World world{.count = static_cast<std::size_t>(state.codes[table::N]),
                .eye = eye.get(state),
                .screen = value_of(state, table::S),
                .box = {.low = low_walls.get(state), .high = high_walls.get(state)},
                .rules = static_cast<Rules>(state.codes[table::MOTION])};
    for (std::size_t i = 0; i < world.count; ++i)
        world.balls[i] = {.centre = centre(i).get(state),
                          .velocity = velocity(i).get(state),
                          .radius = value_of(state, table::index_of(sphere::RADIUS, i))};
    return world;
}

void leave(const World& world, protocol::State& state) noexcept
{
    eye.set(state, world.eye);
    set_value(state, table::S, world.screen);
    for (std::size_t i = 0; i < world.count; ++i) {
        centre(i).set(state, world.balls[i].centre);
        velocity(i).set(state, world.balls[i].velocity);
    }
}

} // namespace raymarch::motion::whitted
