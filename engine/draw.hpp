// SPDX-License-Identifier: MIT
/// @file
/// A whole picture, drawn by any number of threads: the same bytes for any number.
#pragma once

#include "engine/model.hpp"

#include <cstdint>
#include <span>
#include <stop_token>
#include <vector>

namespace raymarch::engine
{

/// Draws every row of `image`. `threads` from 1; 0 means one for each processor. When a stop is
/// requested the picture is left unfinished, at the latest one row a thread later.
/// `frame` is the number of frames before it, see RowOf. Returns what each pixel costs.
std::vector<PixelCost> draw(const Model& model, WordSpan words, Image& image, unsigned threads,
                            std::uint32_t frame = 0, const std::stop_token& stop = {});

/// How many frames of these words it takes until the picture is complete.
[[nodiscard]] inline unsigned frames_of_a_still(const Model& model, WordSpan words) noexcept
{
    return model.frames_of_a_still == nullptr ? 1 : model.frames_of_a_still(words);
}

/// Draws as many frames as a still of these words takes, from number 0 on, into two buffers that
/// take turns as the hardware's do, and leaves the last in `image`, which begins black.
void draw_still(const Model& model, WordSpan words, Image& image, unsigned threads);

/// The clock cycles of a frame on the accelerator's own number of ray units.
[[nodiscard]] std::uint64_t frame_cycles(const Model& model, WordSpan words, PictureSize size,
                                         std::uint32_t frame, std::span<const PixelCost> costs);

} // namespace raymarch::engine
