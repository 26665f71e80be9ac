// SPDX-License-Identifier: MIT
#include "motion/sphere.hpp"

#include <algorithm>

namespace raymarch::motion::sphere
{
namespace
{

/// `value`, moved towards `up` and away from `down`, within the limits. What a host has set beyond
/// them stays, but goes no further.
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
    next.eye.y = moved(world.eye.y, inputs, Down, Up, world.low, world.high); // y points down
    // The picture turns over where the eye is beyond the screen plane.
    next.eye.z = moved(world.eye.z, inputs, Forward, Back, world.low, world.screen - 1);
    next.screen = moved(world.screen, inputs, Narrow, Widen, next.eye.z + 1, world.high);
    return next;
}

} // namespace raymarch::motion::sphere
