// SPDX-License-Identifier: MIT
/// @file
/// Whole pictures, and the choice among the ways to draw them.
#pragma once

#include "engine/painter.hpp"

#include <cstdint>
#include <optional>
#include <span>
#include <stop_token>
#include <vector>

namespace raymarch::engine
{

/// The model's kernel for an instruction set that this processor has; nullptr where there is none:
/// the reference draws. Nothing named: the fastest there is.
[[nodiscard]] const Kernel* kernel_of(const Model& model,
                                      std::optional<Isa> isa = std::nullopt) noexcept;

/// Draws the region, or, where pixels owe something to those before them, the whole picture. One
/// that is stopped is unfinished.
void draw_frame(Painter& painter, const Drawing& drawing, const Region& region,
                const Canvas& canvas, const std::stop_token& stop = {});

/// Draws every row of `image` by the reference, on `threads` as Painter has them. Returns what each
/// pixel costs.
std::vector<PixelCost> draw(const Model& model, WordSpan words, Image& image, unsigned threads,
                            std::uint32_t frame = 0, const std::stop_token& stop = {});

/// How many frames of these words it takes until the picture is complete.
[[nodiscard]] inline unsigned frames_of_a_still(const Model& model, WordSpan words) noexcept
{
    return model.latch(words)->frames();
}

/// Draws as many frames as a still of these words takes, from number 0 on, into two buffers that
/// take turns as the hardware's do, and leaves the last in `image`, which begins black. Pixels
/// outside `tile` are undefined.
void draw_still(Painter& painter, const Drawing& drawing, const Region& tile, Image& image);
inline void draw_still(Painter& painter, const Drawing& drawing, Image& image)
{
    draw_still(painter, drawing, whole(image.size), image);
}

/// The clock cycles of a frame on the accelerator's own number of ray units.
[[nodiscard]] std::uint64_t frame_cycles(const Model& model, WordSpan words, PictureSize size,
                                         std::uint32_t frame, std::span<const PixelCost> costs);

} // namespace raymarch::engine
