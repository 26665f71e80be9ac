// SPDX-License-Identifier: MIT
/// @file
/// The one interface of every accelerator's model: register words in, pixels out.
#pragma once

#include "engine/image.hpp"
#include "protocol/parameters.hpp"

#include <cstdint>
#include <span>
#include <string_view>

namespace raymarch::engine
{

using WordSpan = std::span<const std::uint32_t>;

/// Which row of which picture.
struct RowOf
{
    PictureSize size;
    std::uint16_t y = 0;     ///< from the top
    std::uint32_t frame = 0; ///< frames finished since reset: what checkerboards alternate by
};

/// What one pixel costs the source's hardware. The unit of `steps` is the model's own: scene
/// queries, evaluations of a distance, or clock cycles.
struct PixelCost
{
    std::uint32_t steps = 0;
    std::uint32_t rays = 0; ///< traced for it, shadow rays and reflections among them
    bool operator==(const PixelCost&) const = default;
};

/// One accelerator's computation. Pure: the same arguments give the same bytes, on every machine
/// and from any number of threads.
struct Model
{
    const protocol::Accelerator* description;
    std::string_view steps; ///< what PixelCost counts, in the plural

    /// Draws one row: `pixels` holds 3 * width bytes, `costs` width of them. A pixel that this
    /// frame does not draw keeps its bytes (an accelerator with two buffers: those of two frames
    /// before) and costs nothing.
    void (*draw_row)(WordSpan words, RowOf row, std::span<std::uint8_t> pixels,
                     std::span<PixelCost> costs) noexcept;

    /// The clock cycles that `units` ray units of the source's hardware take for the frame that
    /// cost `costs`, rows from the top.
    std::uint64_t (*frame_cycles)(WordSpan words, RowOf last_row, std::span<const PixelCost> costs,
                                  unsigned units) noexcept;

    /// Where the value of a pixel depends on those drawn before it: called once behind the last
    /// row, from one thread. nullptr where no pixel does.
    void (*finish)(WordSpan words, Image& image, std::span<PixelCost> costs) noexcept = nullptr;

    /// How many frames of the same words it takes until the picture is complete; nullptr: one.
    unsigned (*frames_of_a_still)(WordSpan words) noexcept = nullptr;

    /// The rays of the frame that cost `costs`, where the hardware also draws pixels beyond the
    /// picture; nullptr: the sum of the costs'.
    std::uint64_t (*frame_rays)(WordSpan words, PictureSize size,
                                std::span<const PixelCost> costs) noexcept = nullptr;
};

} // namespace raymarch::engine
