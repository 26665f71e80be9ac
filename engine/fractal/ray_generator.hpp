// SPDX-License-Identifier: MIT
/// @file
/// The ray generator stage (source 001, section V.A): the direction of a pixel's ray.
#pragma once

#include "engine/fractal/formats.hpp"
#include "engine/image.hpp"

#include <cstdint>

namespace raymarch::engine::fractal
{

/// The camera's axes. Neither right nor up is normalised: with a forward of length s they have
/// lengths up to s and s^2.
struct Camera
{
    Point forward;
    Point right;
    Point up;
};

[[nodiscard]] Camera camera_along(const Point& forward) noexcept;

/// The picture plane: the coordinates of the first pixel, and of one pixel's step, both ways.
struct Plane
{
    Number left;
    Number top;
    Number step;
};

/// The plane of a picture from 1 x 1 on: 2 units high, floored, so that it ends a little early.
[[nodiscard]] Plane plane_of(PictureSize size) noexcept;

/// The coordinate of a column or a row.
[[nodiscard]] Number along(Number first, Number step, std::uint16_t count) noexcept;

/// The direction, of length about 1, of the ray through pixel (x, y), y from the top.
[[nodiscard]] Point ray_direction(const Camera& camera, const Plane& plane, std::uint16_t x,
                                  std::uint16_t y) noexcept;

} // namespace raymarch::engine::fractal
