// SPDX-License-Identifier: MIT
/// @file
/// The user control of the fractal (source 001, section III): walking, flying and turning in a
/// scene, with its collision test. Every movement of the hardware is a TICK followed by a CHECK
/// (docs/engine/fractal.md, "Movement").
#pragma once

#include "engine/fractal/formats.hpp"
#include "engine/fractal/scenes.hpp"
#include "motion/inputs.hpp"
#include "protocol/parameters.hpp"

#include <cstdint>

namespace raymarch::motion::fractal
{

enum class Collision : std::uint8_t {
    Faithful, ///< the hardware's test, which allows the step after a refused one
    Closed,   ///< no step ends inside a wall
};

/// What a step needs and remembers: the registers of the user control, as they are after reset.
struct World
{
    engine::fractal::Point position{{}, engine::fractal::one, -engine::fractal::three_halves};
    engine::fractal::Point wanted = position; ///< where the tick would go if the check allows it
    engine::fractal::Point forward{{}, {}, engine::fractal::one}; ///< y never changes
    engine::fractal::Scene scene = engine::fractal::Scene::Menger;
    Collision collision = Collision::Faithful;
    std::uint8_t hue = 0;
    bool odd = false;     ///< ticks alternate: even ones walk, odd ones strafe
    bool in_wall = false; ///< the last check found `wanted` in a wall
    bool operator==(const World&) const = default;
};

/// Sets `wanted` as the inputs say, 0.01 units a tick, and turns at once, by 0.01 a tick. Opposite
/// inputs cancel each other, but if both turns are set, the left one wins.
[[nodiscard]] World tick(const World& world, Inputs inputs) noexcept;

/// Moves to `wanted` if the collision test allows it; otherwise the position stays.
[[nodiscard]] World check(const World& world) noexcept;

/// Makes one tick and its check. Animate also adds one to the hue.
[[nodiscard]] World step(const World& world, Inputs inputs) noexcept;

/// Takes the position from the state. The first tick is an even one.
[[nodiscard]] World enter(const protocol::State& state) noexcept;

/// Writes position, direction and hue into the state.
void leave(const World& world, protocol::State& state) noexcept;

} // namespace raymarch::motion::fractal
