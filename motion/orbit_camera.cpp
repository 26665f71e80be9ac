// SPDX-License-Identifier: MIT
#include "motion/orbit_camera.hpp"

#include "motion/nearest_code.hpp"

#include <cmath>
#include <numbers>

namespace raymarch::motion
{

using namespace protocol; // NOLINT(google-build-using-namespace): most names

void set_orbit(const Accelerator& accelerator, double yaw_degrees, double pitch_degrees,
               State& state) noexcept
{
    constexpr double radians = std::numbers::pi / 180.0;
    const double yaw = std::fmod(yaw_degrees, 360.0) * radians;
    const double pitch = pitch_degrees * radians;
    const Triple forward = {std::cos(pitch) * std::sin(yaw), std::sin(pitch),
                            std::cos(pitch) * std::cos(yaw)};
    const Triple right = {std::cos(yaw), 0.0, -std::sin(yaw)};
    const Triple up = {forward[1] * right[2] - forward[2] * right[1],
                       forward[2] * right[0] - forward[0] * right[2],
                       forward[0] * right[1] - forward[1] * right[0]};
    set_triple(accelerator, accelerator.camera->forward, forward, state);
    set_triple(accelerator, accelerator.camera->right, right, state);
    set_triple(accelerator, accelerator.camera->up, up, state);
}

} // namespace raymarch::motion
