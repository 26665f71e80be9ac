// SPDX-License-Identifier: MIT
/// @file
/// The moving demo of the sphere tracer (source 002): the sphere steps to the right once a frame
/// and starts again at the left. The camera moves too, although the source has it only as
/// parameters.
#pragma once

#include "engine/sphere/frame.hpp"
#include "motion/inputs.hpp"
#include "protocol/parameters.hpp"

#include <cstdint>

namespace raymarch::motion::sphere
{

using engine::sphere::Point;

inline constexpr std::int32_t camera_step = 10;

/// The values that a step reads and changes. They begin as the hardware has them at power-up.
struct World
{
    std::int32_t ball_x = 320; ///< x of the first sphere
    Point eye{320, 240, 0};
    std::int32_t screen = 1000; ///< z of the screen plane
    std::int32_t low = 0;       ///< the range of a coordinate, with `high`; both ends are included
    std::int32_t high = 0xFFFF;
    bool operator==(const World&) const = default;
};

/// Makes one step. Animate moves the sphere by 5, and from 540 back to 100. The camera moves by 10
/// units inside the range of its registers, and not through the screen plane. Widen and Narrow move
/// that plane. Turning does nothing, because the camera looks along z. Opposite inputs cancel.
[[nodiscard]] World step(const World& world, Inputs inputs) noexcept;

/// The values as the design's registers hold them. The hardware's registers, unless corrected, drop
/// the bits above 16, and give the limits. Otherwise the limits are the ranges of the parameters.
[[nodiscard]] World enter(const protocol::State& state) noexcept;
/// Writes the first sphere's x, the camera and the screen plane into the state.
void leave(const World& world, protocol::State& state) noexcept;

} // namespace raymarch::motion::sphere
