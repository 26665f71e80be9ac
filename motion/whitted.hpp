// SPDX-License-Identifier: MIT
/// @file
/// The host program of the ray tracer (source 004, "Software Overview"): spheres that bounce off
/// walls and off each other, the scene's rotation, the eye and the screen.
///
/// All of it is in float, as in the source: a word of 24 bits is exact in one.
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

/// One sphere of the scene, the light excepted.
struct Ball
{
    Point centre;
    Point velocity; ///< units a step
    float radius = 1;
    int rest = 0; ///< until it is 0 the ball looks for no collision
    bool operator==(const Ball&) const = default;
};

/// What a ball bounces off: the walls of a box, touched by its surface.
struct Box
{
    Point low{-30, -30, -30};
    Point high{30, 30, 30};
    bool operator==(const Box&) const = default;
};

/// Whose rules: the source's program, or what it means to do.
enum class Rules : unsigned char { Original, Repaired };

/// Everything that a step needs and changes.
struct World
{
    std::array<Ball, max_balls> balls{};
    std::size_t count = 0; ///< of the balls
    Point eye{0, 0, -32};
    float screen = 8; ///< its distance, in units of 32
    Box box{};
    Rules rules = Rules::Repaired;
    bool operator==(const World&) const = default;
};

/// One frame: the balls move where asked, then the scene turns, then the eye and the screen move.
/// Of two opposite inputs neither counts, and the scene turns only for one input at a time.
[[nodiscard]] World step(const World& world, Inputs inputs) noexcept;

/// The world that a state of the accelerator `whitted` describes; no ball rests.
[[nodiscard]] World enter(const protocol::State& state) noexcept;

/// Writes what a step changes into the state: truncated to the formats, held inside the ranges.
void leave(const World& world, protocol::State& state) noexcept;

} // namespace raymarch::motion::whitted
