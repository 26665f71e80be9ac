// SPDX-License-Identifier: MIT
/// @file
/// Primary rays: where the samples of a pixel lie, and the direction of each.
#pragma once

#include "engine/image.hpp"
#include "engine/whitted/frame.hpp"

#include <array>
#include <cstdint>
#include <span>

namespace raymarch::engine::whitted
{

/// One sample of a pixel.
struct SamplePlace
{
    std::int8_t dx; ///< half pixels
    std::int8_t dy;
    std::uint8_t shift; ///< its share of the pixel is 2^-shift
};

/// The samples of a pixel in their order (source 004, Fig. 9); the shares sum up to 1.
[[nodiscard]] std::span<const SamplePlace> sample_places(AntiAliasing anti_aliasing) noexcept;

/// From the eye to a sample on the screen, in units of 32: what primary_direction normalises. Each
/// component depends on its own coordinate of the sample alone, and on where it is, not on which
/// pixel it is a sample of.
[[nodiscard]] Vector screen_point(const Frame& frame, PictureSize size, unsigned x, unsigned y,
                                  const SamplePlace& place) noexcept;

/// The direction, as a unit vector, of a sample of pixel (x, y), from the top left; both may be one
/// beyond the picture. The middle of the picture is where x = width / 2.
[[nodiscard]] Vector primary_direction(const Frame& frame, PictureSize size, unsigned x, unsigned y,
                                       const SamplePlace& place) noexcept;

} // namespace raymarch::engine::whitted
