// SPDX-License-Identifier: MIT
/// @file
/// Draws random values for RANDOM.
#pragma once

#include "protocol/parameters.hpp"

#include <random>
#include <string_view>

namespace raymarch::motion
{

/// Sets the parameters of `group` (all if empty) to random values inside their ranges. The camera
/// gets a random orbit, so that its vectors are a basis, and a colour gets a random hue.
void randomise(const protocol::Accelerator& accelerator, std::string_view group,
               std::mt19937_64& random, protocol::State& state) noexcept;

} // namespace raymarch::motion
