// SPDX-License-Identifier: MIT
/// @file
/// The ray generator (source 003, §II, §IV.A): the unit vector through a pixel's centre.
#pragma once

#include "engine/mandelbulb/frame.hpp"
#include "engine/model.hpp"

#include <cstdint>

namespace raymarch::engine::mandelbulb
{

/// The ray of pixel (x, y), Q1.57; zero where the basis says nothing.
[[nodiscard]] Direction ray_direction(const Frame& frame, PictureSize size, std::uint16_t x,
                                      std::uint16_t y) noexcept;

/// The vector before it is normalised: from the camera to the pixel's place on a plane before it.
/// Components are below 2^60.
[[nodiscard]] Direction ray_vector(const Frame& frame, PictureSize size, std::uint16_t x,
                                   std::uint16_t y) noexcept;

/// v as a unit vector: each component times 2^57 over the floored length, towards zero. Components
/// are below 2^60.
[[nodiscard]] Direction unit_vector(const Direction& v) noexcept;

} // namespace raymarch::engine::mandelbulb
