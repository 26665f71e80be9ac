// SPDX-License-Identifier: MIT
/// @file
/// The ray generator stage (source 000, §4.1.4): the direction of a pixel's ray.
#pragma once

#include "engine/image.hpp"
#include "engine/marcher/formats.hpp"
#include "engine/marcher/frame.hpp"

#include <cstdint>

namespace raymarch::engine::marcher
{

/// The unit direction, in Q8.24, of the ray through the centre of pixel (x, y), y from the top.
///
/// ndc_x * right + ndc_y * up - forward, taken height times, is a sum of integers: half pixels
/// times Q1.17. Normalising makes the factor vanish, so nothing is divided and nothing is lost.
[[nodiscard]] Point ray_direction(const Frame& frame, PictureSize size, std::uint16_t x,
                                  std::uint16_t y) noexcept;

} // namespace raymarch::engine::marcher
