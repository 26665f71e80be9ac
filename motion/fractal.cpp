// SPDX-License-Identifier: MIT
#include "motion/fractal.hpp"

#include "protocol/accelerators/fractal.hpp"

namespace raymarch::motion::fractal
{
namespace
{

using engine::fractal::hundredth;
using engine::fractal::multiply;
using engine::fractal::Number;
using engine::fractal::Point;
using engine::fractal::word;

constexpr Number climb = word(512); ///< the height gained or lost in a tick, 1/128
constexpr Number cosine = word(65532);
constexpr Number sine = word(655); ///< sin(0.01)

/// Returns +1 or -1, and 0 if both inputs or neither are set.
int balance(Inputs inputs, Input plus, Input minus) noexcept
{
    return (inputs.has(plus) ? 1 : 0) - (inputs.has(minus) ? 1 : 0);
}

Number moved(Number from, int direction, Number by) noexcept
{
    // To go back, the hardware subtracts this product; it does not multiply a negated direction.
    return direction > 0 ? from + by : direction < 0 ? from - by : from;
}

Point turned(const Point& forward, Number m) noexcept
{
    return {multiply(forward.x, cosine) + multiply(forward.z, m), forward.y,
            multiply(forward.x, -m) + multiply(forward.z, cosine)};
}

/// Whether the hardware lets a step end at this distance. Its one exception is not handled here.
bool is_free(Number distance) noexcept
{
    return distance > hundredth;
}

} // namespace

World tick(const World& world, Inputs inputs) noexcept
{
    World next = world;
    next.wanted.y = moved(world.position.y, balance(inputs, Input::Up, Input::Down), climb);

    const Number along_x = multiply(world.forward.x, hundredth);
    const Number along_z = multiply(world.forward.z, hundredth);
    if (world.odd) {
        const int right = balance(inputs, Input::StrafeRight, Input::StrafeLeft);
        next.wanted.x = moved(world.position.x, right, along_z);
        next.wanted.z = moved(world.position.z, -right, along_x);
    } else {
        const int ahead = balance(inputs, Input::Forward, Input::Back);
        next.wanted.x = moved(world.position.x, ahead, along_x);
        next.wanted.z = moved(world.position.z, ahead, along_z);
    }

    if (inputs.has(Input::TurnLeft))
        next.forward = turned(world.forward, -sine);
    else if (inputs.has(Input::TurnRight))
        next.forward = turned(world.forward, sine);
    next.odd = !world.odd;
    return next;
}

World check(const World& world) noexcept
{
    const engine::fractal::Distance distance = engine::fractal::scene_row(world.scene).distance;
    const Number there = distance(world.wanted);
    // The scene may change around the camera, so that it stands in a wall. Closed then lets it
    // leave the wall, but not go deeper.
    const bool accepted = is_free(there) || (world.collision == Collision::Faithful
                                                 ? world.in_wall
                                                 : there >= distance(world.position));
    World next = world;
    if (accepted)
        next.position = world.wanted;
    else
        next.wanted = world.position;
    next.in_wall = there < hundredth;
    return next;
}

World step(const World& world, Inputs inputs) noexcept
{
    World next = check(tick(world, inputs));
    if (inputs.has(Input::Animate))
        next.hue = static_cast<std::uint8_t>(next.hue + 1);
    return next;
}

World enter(const protocol::State& state) noexcept
{
    namespace table = protocol::fractal;
    const auto point = [&](protocol::ParameterIndex x, protocol::ParameterIndex y,
                           protocol::ParameterIndex z) {
        return Point{Number::from_raw(state.codes[x]), Number::from_raw(state.codes[y]),
                     Number::from_raw(state.codes[z])};
    };
    World world;
    world.position = world.wanted = point(table::X, table::Y, table::Z);
    world.forward = point(table::FX, table::FY, table::FZ);
    world.scene = static_cast<engine::fractal::Scene>(state.codes[table::SCENE]);
    world.collision = static_cast<Collision>(state.codes[table::COLLISION]);
    world.hue = static_cast<std::uint8_t>(state.codes[table::HUE]);
    return world;
}

void leave(const World& world, protocol::State& state) noexcept
{
    namespace table = protocol::fractal;
    state.codes[table::X] = world.position.x.raw();
    state.codes[table::Y] = world.position.y.raw();
    state.codes[table::Z] = world.position.z.raw();
    state.codes[table::FX] = world.forward.x.raw();
    state.codes[table::FY] = world.forward.y.raw();
    state.codes[table::FZ] = world.forward.z.raw();
    state.codes[table::HUE] = world.hue;
}

} // namespace raymarch::motion::fractal
