// SPDX-License-Identifier: MIT
/// @file
/// Draws the Mandelbulb in floating point, like a program for a graphics card (source 003, §V.A,
/// Fig. 9), for a comparison with the fixed-point pictures.
#pragma once

#include "engine/mandelbulb/frame.hpp"
#include "engine/mandelbulb/ray_marcher.hpp"
#include "engine/model.hpp"

#include <cstdint>
#include <span>

namespace raymarch::tools
{

/// The formula for the angle from the z axis: acos(z/r), as in shaders, or atan2, which is about
/// one bit more accurate.
enum class ThetaBy : std::uint8_t { Acos, Atan2 };

template <typename Real>
struct ReferenceRay
{
    engine::mandelbulb::Outcome outcome = engine::mandelbulb::Outcome::Limit;
    int evaluations = 0;
    int index = 0; ///< the index of the last evaluation
    Real t = 0;    ///< the distance along the ray
};

/// Marches the ray of pixel (x, y) with the parameters of the frame and the arithmetic of Real,
/// which is float, double or long double.
template <typename Real>
[[nodiscard]] ReferenceRay<Real> march_reference(const engine::mandelbulb::Frame& frame,
                                                 engine::PictureSize size, std::uint16_t x,
                                                 std::uint16_t y, ThetaBy theta) noexcept;

/// Draws a row with the colours of engine::mandelbulb::draw_row.
template <typename Real>
void draw_reference_row(const engine::mandelbulb::Frame& frame, engine::RowOf row,
                        std::span<std::uint8_t> pixels, std::span<engine::PixelCost> costs,
                        ThetaBy theta) noexcept;

} // namespace raymarch::tools
