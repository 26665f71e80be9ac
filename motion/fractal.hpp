// SPDX-License-Identifier: MIT
/// @file
/// The user control of the fractal (source 001, section III): walking, flying and turning in a
/// scene, with its collision test. Every movement of the hardware is a TICK and the CHECK behind
/// it (docs/engine/fractal.md, "Movement").
#pragma once

#include "engine/fractal/formats.hpp"
#include "engine/fractal/scenes.hpp"
#include "motion/inputs.hpp"
#include "protocol/parameters.hpp"

#include <cstdint>

namespace raymarch::motion::fractal
{

enum class Collision : std::uint8_t {
    Faithful, ///< the hardware's, which lets through the step behind a refused one
    Closed,   ///< no step ends inside a wall
};

/// What a step needs and remembers: the registers of the user control, as they are after reset.
struct World
{
    engine::fractal::Point position{{}, engine::fractal::one, -engine::fractal::three_halves};
    engine::fractal::Point wanted = position; ///< where a tick wants to go, until the check
    engine::fractal::Point forward{{}, {}, engine::fractal::one}; ///< y never changes
    engine::fractal::Scene scene = engine::fractal::Scene::Menger;
    Collision collision = Collision::Faithful;
    std::uint8_t hue = 0;
    bool odd = false;     ///< ticks alternate: even ones walk, odd ones strafe
    bool in_wall = false; ///< the last check found `wanted` in a wall
    bool operator==(const World&) const = default;
};

/// Wants to go where the inputs say, 0.01 units and turns of 0.01 a tick, and turns at once.
/// Inputs that oppose each other cancel; of two turns the left one wins.
[[nodiscard]] World tick(const World& world, Inputs inputs) noexcept;

/// Goes there, or stays.
[[nodiscard]] World check(const World& world) noexcept;

/// One tick and its check; Animate moves the hue on by one.
[[nodiscard]] World step(const World& world, Inputs inputs) noexcept;

/// Begins to move where the state says, with an even tick.
[[nodiscard]] World enter(const protocol::State& state) noexcept;

/// Writes what a step changes: position, direction and hue.
void leave(const World& world, protocol::State& state) noexcept;

} // namespace raymarch::motion::fractal
