// SPDX-License-Identifier: MIT
/// @file
/// The inverse square root stage: a straight line as the guess, two rounds of Newton's method.
#pragma once

#include "engine/fractal/formats.hpp"

namespace raymarch::engine::fractal
{

/// 1 / sqrt(a), for `a` from 0.5 to below 32 within 0.001. Smaller words are not normalised first
/// and give less than the root; a negative word counts as 64 more.
[[nodiscard]] Number inverse_sqrt(Number a) noexcept;

} // namespace raymarch::engine::fractal
