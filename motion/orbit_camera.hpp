// SPDX-License-Identifier: MIT
/// @file
/// Sets the vectors of a camera that circles the origin: VIEW, RANDOM and the marcher's movements.
#pragma once

#include "protocol/parameters.hpp"

namespace raymarch::motion
{

/// Sets forward, right and up to the codes nearest to
/// F = (cos p sin a, sin p, cos p cos a), R = normalise((0,1,0) x F), U = F x R.
/// At yaw a = 0 the camera is at +z, at yaw 90 it is at +x; a positive pitch p raises it.
/// Precondition: the accelerator has an orbit camera.
void set_orbit(const protocol::Accelerator& accelerator, double yaw_degrees, double pitch_degrees,
               protocol::State& state) noexcept;

} // namespace raymarch::motion
