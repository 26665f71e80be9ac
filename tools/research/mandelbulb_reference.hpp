// SPDX-License-Identifier: MIT
/// @file
/// The Mandelbulb as a program for a graphics card computes it (source 003, §V.A, Fig. 9): in
/// floating point. What the fixed-point pictures of the same view are compared with.
#pragma once

#include "engine/mandelbulb/frame.hpp"
#include "engine/mandelbulb/ray_marcher.hpp"
#include "engine/model.hpp"

#include <cstdint>
#include <span>

namespace raymarch::tools
{

/// How the angle from the z axis is found: as shaders do, acos(z/r), or with atan2, which keeps
/// about one bit more.
enum class ThetaBy : std::uint8_t { Acos, Atan2 };

template <typename Real>
struct ReferenceRay
{
    engine::mandelbulb::Outcome outcome = engine::mandelbulb::Outcome::Limit;
    int evaluations = 0;
    int index = 0; ///< of the last evaluation
    Real t = 0;    ///< the way gone
};

/// The ray of pixel (x, y): camera, power, iterations and limits of the frame, Real's arithmetic.
/// Real is float, double or long double.
template <typename Real>
[[nodiscard]] ReferenceRay<Real> march_reference(const engine::mandelbulb::Frame& frame,
                                                 engine::PictureSize size, std::uint16_t x,
                                                 std::uint16_t y, ThetaBy theta) noexcept;

/// As engine::mandelbulb::draw_row, with its colours.
template <typename Real>
void draw_reference_row(const engine::mandelbulb::Frame& frame, engine::RowOf row,
                        std::span<std::uint8_t> pixels, std::span<engine::PixelCost> costs,
                        ThetaBy theta) noexcept;

} // namespace raymarch::tools
