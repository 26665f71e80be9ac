// SPDX-License-Identifier: MIT
/// @file
/// Sets the colour from a hue.
#pragma once

#include "protocol/parameters.hpp"

namespace raymarch::motion
{

/// Converts HSV to RGB at full saturation and value. `hue` is 0 to 1, and both ends are red.
/// Precondition: the accelerator has a colour.
void set_hue(const protocol::Accelerator& accelerator, double hue, protocol::State& state) noexcept;

} // namespace raymarch::motion
