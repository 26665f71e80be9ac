// SPDX-License-Identifier: MIT
/// @file
/// One sample: a primary ray and its reflections, each with its shadow ray (source 004, Fig. 4).
#pragma once

#include "engine/model.hpp"
#include "engine/whitted/formats.hpp"
#include "engine/whitted/frame.hpp"

namespace raymarch::engine::whitted
{

struct Sample
{
    Colour colour{};
    bool sees_light = false;    ///< its primary ray hits the light
    bool ends_at_light = false; ///< the last sphere that it hits is the light
    PixelCost cost{};           ///< clock cycles and rays
};

/// Follows a ray from the eye.
[[nodiscard]] Sample trace(const Frame& frame, const Vector& direction) noexcept;

} // namespace raymarch::engine::whitted
