// SPDX-License-Identifier: MIT
#include "motion/marcher.hpp"

#include "motion/orbit_camera.hpp"
#include "protocol/accelerators/marcher.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace raymarch::motion::marcher
{
namespace
{

namespace table = protocol::marcher;

constexpr double degrees = 180.0 / std::numbers::pi;
constexpr double steepest = 89.0;
constexpr std::int64_t zoom_step = std::int64_t{1} << (table::zoom_format.fraction_bits - 5);

int sign(Inputs inputs, Input plus, Input minus) noexcept
{
    return (inputs.has(plus) ? 1 : 0) - (inputs.has(minus) ? 1 : 0);
}

} // namespace

World step(const World& world, Inputs inputs) noexcept
{
    World next = world;
    const int right = sign(inputs, Input::TurnRight, Input::TurnLeft) +
                      sign(inputs, Input::StrafeRight, Input::StrafeLeft) +
                      (inputs.has(Input::Animate) ? 1 : 0);
    const int up =
        sign(inputs, Input::TurnUp, Input::TurnDown) + sign(inputs, Input::Up, Input::Down);
    next.yaw = std::remainder(world.yaw + right, 360.0);
    next.pitch = std::clamp(world.pitch + up, -steepest, steepest);
    const protocol::Parameter& zoom = table::parameters[table::ZM];
    next.zoom = std::clamp(world.zoom - sign(inputs, Input::Forward, Input::Back) * zoom_step,
                           zoom.min_scaled, zoom.max_scaled);
    return next;
}

World enter(const protocol::State& state) noexcept
{
    const auto component = [&](protocol::ParameterIndex index) {
        return std::ldexp(static_cast<double>(state.codes[index]),
                          -table::direction_format.fraction_bits);
    };
    const double x = component(table::FX);
    const double y = component(table::FY);
    const double z = component(table::FZ);
    return {.yaw = std::atan2(x, z) * degrees,
            .pitch = std::atan2(y, std::hypot(x, z)) * degrees,
            .zoom = state.codes[table::ZM]};
}

void leave(const World& world, protocol::State& state) noexcept
{
    set_orbit(table::description, world.yaw, world.pitch, state);
    state.codes[table::ZM] = world.zoom;
}

} // namespace raymarch::motion::marcher
