// SPDX-License-Identifier: MIT
/// @file
/// The sphere tracer composed: a frame in, pictures and edges out (docs/engine/sphere.md).
#pragma once

#include "engine/image.hpp"
#include "engine/model.hpp"
#include "engine/sphere/frame.hpp"

#include <cstdint>
#include <span>

namespace raymarch::engine::sphere
{

/// See Model. A step is an edge of the hardware's clock, in the prototype an evaluation of the
/// ray-sphere unit.
void draw_row(const Frame& frame, RowOf row, std::span<std::uint8_t> pixels,
              std::span<PixelCost> costs) noexcept;

/// See Model: what the hardware's state makes of the pixels of a first frame after power-up.
void finish(const Frame& frame, const Canvas& canvas) noexcept;

/// See Model: the edges of all pixels, one after another. The prototype's are those that the
/// hardware's unit would need for its evaluations, were each to run to the end.
[[nodiscard]] std::uint64_t frame_cycles(const Frame& frame,
                                         std::span<const PixelCost> costs) noexcept;

/// The same from words, as Model has it.
void draw_row(WordSpan words, RowOf row, std::span<std::uint8_t> pixels,
              std::span<PixelCost> costs) noexcept;
void finish(WordSpan words, const Canvas& canvas) noexcept;
std::uint64_t frame_cycles(WordSpan words, RowOf last_row, std::span<const PixelCost> costs,
                           unsigned units) noexcept;

} // namespace raymarch::engine::sphere
