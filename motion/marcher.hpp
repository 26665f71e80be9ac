// SPDX-License-Identifier: MIT
/// @file
/// The orbit of the marcher's camera around its target (source 000, section 5.1): turning changes
/// yaw and pitch, walking the distance.
#pragma once

#include "motion/inputs.hpp"
#include "protocol/parameters.hpp"

#include <cstdint>

namespace raymarch::motion::marcher
{

/// The position of the camera, seen from its target.
struct World
{
    double yaw = 0;        ///< degrees, from +z towards +x
    double pitch = 0;      ///< degrees, upwards; the poles are excluded
    std::int64_t zoom = 0; ///< the parameter's code
    bool operator==(const World&) const = default;
};

/// Makes one step. Turning and rolling move the camera by 1 degree, Forward and Back change the
/// distance by 1/32 unit inside the parameter's range, and Animate turns by 1 degree. Opposite
/// inputs cancel each other. The other inputs do nothing.
[[nodiscard]] World step(const World& world, Inputs inputs) noexcept;

[[nodiscard]] World enter(const protocol::State& state) noexcept;
/// Writes the camera's basis and its distance into the state.
void leave(const World& world, protocol::State& state) noexcept;

} // namespace raymarch::motion::marcher
