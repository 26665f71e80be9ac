// SPDX-License-Identifier: MIT
/// @file
/// The C program: one pixel of several spheres, each of its own colour, and several lights.
#pragma once

#include "engine/sphere/frame.hpp"

#include <array>
#include <cstdint>

namespace raymarch::engine::sphere
{

struct PrototypePixel
{
    std::array<std::uint8_t, 3> colour{}; ///< red, green, blue
    std::uint32_t evaluations = 0;        ///< of the ray-sphere unit
    std::uint32_t rays = 1;               ///< the shadow rays among them
};

[[nodiscard]] PrototypePixel prototype_pixel(const Frame& frame, std::int32_t x,
                                             std::int32_t y) noexcept;

} // namespace raymarch::engine::sphere
