// SPDX-License-Identifier: MIT
/// @file
/// The moving demo of the sphere tracer (source 002): the sphere steps to the right once a frame
/// and starts again; and a camera that moves, which the source has only as parameters.
#pragma once

#include "engine/sphere/frame.hpp"
#include "motion/inputs.hpp"
#include "protocol/parameters.hpp"

#include <cstdint>

namespace raymarch::motion::sphere
{

using engine::sphere::Point;

inline constexpr std::int32_t camera_step = 10;

/// What a step needs and changes; initially the hardware at power-up.
struct World
{
    std::int32_t ball_x = 320; ///< of the first sphere
    Point eye{320, 240, 0};
    std::int32_t screen = 1000; ///< z of the screen plane
    std::int32_t low = 0;       ///< what the coordinates' registers hold, both included
    std::int32_t high = 0xFFFF;
    bool operator==(const World&) const = default;
};

/// Animate moves the sphere by 5, from 540 on back to 100. The camera moves by 10 units, as far as
/// its registers go, and not through the screen plane; Widen and Narrow move that plane. Turning
/// does nothing: the camera looks along z. Of two opposite inputs neither counts.
[[nodiscard]] World step(const World& world, Inputs inputs) noexcept;

/// The values as the design's registers hold them: the hardware's, unless corrected, lose the bits
/// above 16, and its limits are theirs; otherwise the limits are the parameters' range.
[[nodiscard]] World enter(const protocol::State& state) noexcept;
/// Writes the first sphere's x, the camera and the screen plane.
void leave(const World& world, protocol::State& state) noexcept;

} // namespace raymarch::motion::sphere
