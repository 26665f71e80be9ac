// SPDX-License-Identifier: MIT
/// @file
/// The sphere tracer composed: a frame in, pictures and edges out (docs/engine/sphere.md).
#pragma once

#include "engine/image.hpp"
#include "engine/model.hpp"
#include "engine/sphere/frame.hpp"

#include <array>
#include <cstdint>
#include <span>

namespace raymarch::engine::sphere
{

struct Pixel
{
    std::array<std::uint8_t, bytes_per_pixel> colour;
    PixelCost cost;
};

/// Pixel (x, y) of a frame that is held().
[[nodiscard]] Pixel draw_pixel(const Frame& registers, std::int32_t x, std::int32_t y) noexcept;

/// See Picture::draw. A step is an edge of the hardware's clock, in the prototype an evaluation of
/// the ray-sphere unit.
void draw_row(const Frame& frame, RowOf row, std::span<std::uint8_t> pixels,
              std::span<PixelCost> costs) noexcept;

/// See Picture::complete: what the hardware's state makes of the pixels of a first frame after
/// power-up.
void finish(const Frame& frame, const Canvas& canvas) noexcept;

/// See Picture::cycles: the edges of all pixels, one after another. The prototype's are those that
/// the hardware's unit would need for its evaluations, were each to run to the end.
[[nodiscard]] std::uint64_t frame_cycles(const Frame& frame, RowOf last_row,
                                         std::span<const PixelCost> costs, unsigned units) noexcept;

} // namespace raymarch::engine::sphere
