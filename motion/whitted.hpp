// SPDX-License-Identifier: MIT
/// @file
/// The host program of the ray tracer (source 004, "Software Overview"). It moves spheres that
/// bounce off walls and off each other, turns the scene, and moves the eye and the screen.
///
/// It computes in float, as the source does. A float holds any word of 24 bits exactly.
#pragma once

#include "engine/vec3.hpp"
#include "motion/inputs.hpp"
#include "protocol/parameters.hpp"

#include <array>
#include <cstddef>

namespace raymarch::motion::whitted
{

using Point = engine::Vec3<float>;

inline constexpr std::size_t max_balls = 14;

/// One sphere of the scene. The light is not among them.
struct Ball
{
    Point centre;
    Point velocity; ///< units a step
    float radius = 1;
    int rest = 0; ///< while it is above 0, collisions of the ball are ignored
    bool operator==(const Ball&) const = default;
};

/// The walls of the box in which the balls bounce.
struct Box
{
    Point low{-30, -30, -30};
    Point high{30, 30, 30};
    bool operator==(const Box&) const = default;
};

/// The rules of the source's program, or the rules that it was meant to have.
enum class Rules : unsigned char { Original, Repaired };

/// Everything that a step reads and changes.
struct World
{
    std::array<Ball, max_balls> balls{};
    std::size_t count = 0; ///< number of balls
    Point eye{0, 0, -32};
    float screen = 8; ///< distance of the screen, in units of 32
    Box box{};
    Rules rules = Rules::Repaired;
    bool operator==(const World&) const = default;
};

/// Makes one step: the balls move if Animate is set, then the scene turns, then the eye and the
/// screen move. Opposite inputs cancel, and the scene turns only if a single turn is asked for.
[[nodiscard]] World step(const World& world, Inputs inputs) noexcept;

/// Makes the world that a state of the accelerator `whitted` describes. No ball rests in it.
[[nodiscard]] World enter(const protocol::State& state) noexcept;

/// Writes what a step changes into the state, truncated to the formats and clamped to the ranges.
void leave(const World& world, protocol::State& state) noexcept;

} // namespace raymarch::motion::whitted
