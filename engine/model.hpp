// SPDX-License-Identifier: MIT
/// @file
/// The one interface of every accelerator's model: register words in, pixels out.
#pragma once

#include "engine/image.hpp"
#include "engine/isa.hpp"
#include "protocol/parameters.hpp"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <span>
#include <string_view>

namespace raymarch::engine
{

using WordSpan = std::span<const std::uint32_t>;

/// Which pixels of a row: from `first` on each `step`-th before `end`.
struct Columns
{
    std::uint16_t first = 0;
    std::uint16_t end = std::numeric_limits<std::uint16_t>::max(); ///< beyond the row: its end
    std::uint16_t step = 1;
};

/// Which row of which picture.
struct RowOf
{
    PictureSize size;
    std::uint16_t y = 0;     ///< from the top
    std::uint32_t frame = 0; ///< frames finished since reset: what checkerboards alternate by
    Columns columns{};       ///< the others keep their bytes and costs

    [[nodiscard]] unsigned end() const noexcept { return std::min(columns.end, size.width); }
};

/// Which pixels of which picture: (x + i * step, y + j * step) inside a rectangle.
struct Region
{
    PictureSize size;    ///< of the whole picture
    std::uint16_t x = 0; ///< the rectangle, inside the picture
    std::uint16_t y = 0;
    std::uint16_t width;
    std::uint16_t height;
    std::uint16_t step = 1;
    std::uint32_t frame = 0; ///< as in RowOf
};

[[nodiscard]] constexpr Region whole(PictureSize size, std::uint32_t frame = 0) noexcept
{
    return {.size = size, .width = size.width, .height = size.height, .frame = frame};
}

/// What one pixel costs the source's hardware. The unit of `steps` is the model's own: scene
/// queries, evaluations of a distance, or clock cycles.
struct PixelCost
{
    std::uint32_t steps = 0;
    std::uint32_t rays = 0; ///< traced for it, shadow rays and reflections among them
    bool operator==(const PixelCost&) const = default;
};

/// Where pixels go: the whole picture, whatever part of it is drawn.
struct Canvas
{
    std::span<std::uint8_t> rgb;  ///< 3 bytes a pixel, rows from the top
    std::span<PixelCost> costs{}; ///< one a pixel; empty: not wanted
};

/// A second way to the same bytes and costs, in the vectors of one instruction set. Where costs are
/// not wanted it may leave out what serves them alone.
struct Kernel
{
    Isa isa;
    /// Draws the pixels of `region`; keeps all others, and those that this frame does not draw.
    void (*draw)(WordSpan words, const Region& region, const Canvas& canvas) noexcept;
};

/// One accelerator's computation. Pure: the same arguments give the same bytes, on every machine
/// and from any number of threads.
struct Model
{
    const protocol::Accelerator* description;
    std::string_view steps; ///< what PixelCost counts, in the plural

    /// Draws one row, or the columns of it that are asked for, by the plain scalar model, which is
    /// the definition of the bits: `pixels` holds 3 * width bytes, `costs` width of them. A pixel
    /// that this frame does not draw keeps its bytes (an accelerator with two buffers: those of two
    /// frames before) and costs nothing.
    void (*draw_row)(WordSpan words, RowOf row, std::span<std::uint8_t> pixels,
                     std::span<PixelCost> costs) noexcept;

    /// The clock cycles that `units` ray units of the source's hardware take for the frame that
    /// cost `costs`, rows from the top.
    std::uint64_t (*frame_cycles)(WordSpan words, RowOf last_row, std::span<const PixelCost> costs,
                                  unsigned units) noexcept;

    /// Where the value of a pixel depends on those drawn before it: called once behind the last
    /// row, from one thread. nullptr where no pixel does.
    void (*finish)(WordSpan words, const Canvas& canvas) noexcept = nullptr;

    /// How many frames of the same words it takes until the picture is complete; nullptr: one.
    unsigned (*frames_of_a_still)(WordSpan words) noexcept = nullptr;

    /// The rays of the frame that cost `costs`, where the hardware also draws pixels beyond the
    /// picture; nullptr: the sum of the costs'.
    std::uint64_t (*frame_rays)(WordSpan words, PictureSize size,
                                std::span<const PixelCost> costs) noexcept = nullptr;

    /// The kernels that were compiled; those whose `draw` is nullptr were not. nullptr: none.
    std::span<const Kernel> (*kernels)() noexcept = nullptr;
};

} // namespace raymarch::engine
