// SPDX-License-Identifier: MIT
#include "motion/sphere.hpp"

#include "protocol/accelerators/sphere.hpp"
#include "protocol/registers.hpp"

#include <algorithm>

namespace raymarch::motion::sphere
{
namespace
{

namespace table = protocol::sphere;

/// Adds a step to `value` if `up` is set, and subtracts one if `down` is set, within the limits. A
/// value that a host has set outside the limits is kept, but does not move further out.
std::int32_t moved(std::int32_t value, Inputs inputs, Input up, Input down, std::int32_t low,
                   std::int32_t high) noexcept
{
    const std::int32_t by = ((inputs.has(up) ? 1 : 0) - (inputs.has(down) ? 1 : 0)) * camera_step;
    if (by > 0)
        return std::min(value + by, std::max(value, high));
    return std::max(value + by, std::min(value, low));
}

} // namespace

World step(const World& world, Inputs inputs) noexcept
{
    using enum Input;
    World next = world;
    if (inputs.has(Animate))
        next.ball_x = world.ball_x < 540 ? world.ball_x + 5 : 100;
    next.eye.x = moved(world.eye.x, inputs, StrafeRight, StrafeLeft, world.low, world.high);
    next.eye.y = moved(world.eye.y, inputs, Down, Up, world.low, world.high); // y grows downwards
    // If the eye passed the screen plane, the picture would be upside down.
    next.eye.z = moved(world.eye.z, inputs, Forward, Back, world.low, world.screen - 1);
    next.screen = moved(world.screen, inputs, Narrow, Widen, next.eye.z + 1, world.high);
    return next;
}

World enter(const protocol::State& state) noexcept
{
    using namespace engine::sphere;
    const Frame frame = held(latch(protocol::pack(table::description, state)));
    World world{.ball_x = frame.balls[0].centre.x, .eye = frame.eye, .screen = frame.screen};
    if (frame.design == Design::Prototype || frame.faults == Faults::Corrected) {
        world.low = static_cast<std::int32_t>(table::parameters[table::EX].min_scaled);
        world.high = static_cast<std::int32_t>(table::parameters[table::EX].max_scaled);
    }
    return world;
}

void leave(const World& world, protocol::State& state) noexcept
{
    state.codes[table::S1] = world.ball_x;
    state.codes[table::EX] = world.eye.x;
    state.codes[table::EY] = world.eye.y;
    state.codes[table::EZ] = world.eye.z;
    state.codes[table::F] = world.screen;
}

} // namespace raymarch::motion::sphere
