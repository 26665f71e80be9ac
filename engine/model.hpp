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
#include <memory>
#include <span>
#include <string_view>

namespace raymarch::engine
{

using WordSpan = std::span<const std::uint32_t>;

/// Selects pixels of a row: first, first + step, … below end.
struct Columns
{
    std::uint16_t first = 0;
    std::uint16_t end =
        std::numeric_limits<std::uint16_t>::max(); ///< a value beyond the row means its end
    std::uint16_t step = 1;
};

/// Names a row of a picture.
struct RowOf
{
    PictureSize size;
    std::uint16_t y = 0;     ///< from the top
    std::uint32_t frame = 0; ///< frames finished since reset; checkerboards alternate by it
    Columns columns{};       ///< other pixels keep their bytes and costs

    [[nodiscard]] unsigned end() const noexcept { return std::min(columns.end, size.width); }
};

/// Selects pixels of a rectangle of a picture: (x + i * step, y + j * step).
struct Region
{
    PictureSize size;    ///< the size of the whole picture
    std::uint16_t x = 0; ///< the rectangle, inside the picture
    std::uint16_t y = 0;
    std::uint16_t width;
    std::uint16_t height;
    std::uint16_t step = 1;
    std::uint32_t frame = 0; ///< see RowOf
};

[[nodiscard]] constexpr Region whole(PictureSize size, std::uint32_t frame = 0) noexcept
{
    return {.size = size, .width = size.width, .height = size.height, .frame = frame};
}

/// A pixel's cost in the source's hardware. The unit of `steps` is the model's own: scene
/// queries, evaluations of a distance, or clock cycles.
struct PixelCost
{
    std::uint32_t steps = 0;
    std::uint32_t rays = 0; ///< traced for it, shadow rays and reflections among them
    bool operator==(const PixelCost&) const = default;
};

/// The buffers that a drawing is written to. They hold the whole picture, even if only a part is
/// drawn.
struct Canvas
{
    std::span<std::uint8_t> rgb;  ///< 3 bytes a pixel, rows from the top
    std::span<PixelCost> costs{}; ///< one for each pixel; empty if costs are not wanted
};

/// A picture whose words are latched: they are decoded once, however many rows and frames are
/// drawn. It is pure: the same arguments give the same bytes, on every machine and from any number
/// of threads.
class Picture
{
  public:
    Picture() = default;
    Picture(const Picture&) = delete;
    Picture& operator=(const Picture&) = delete;
    virtual ~Picture() = default;

    /// Draws one row, or the columns of it that are asked for, by the plain scalar model, which is
    /// the definition of the bits: `pixels` holds 3 * width bytes, `costs` width of them. A pixel
    /// that this frame does not draw keeps its bytes (an accelerator with two buffers: those of two
    /// frames before) and costs nothing.
    virtual void draw(RowOf row, std::span<std::uint8_t> pixels,
                      std::span<PixelCost> costs) const noexcept = 0;

    /// Changes what depends on the order of the pixels. It is called once, from one thread, when
    /// all rows of a picture are drawn.
    virtual void complete(const Canvas& canvas) const noexcept = 0;

    /// Returns how many clock cycles the source's hardware takes for a frame with these costs, rows
    /// from the top, if it has `units` ray units.
    [[nodiscard]] virtual std::uint64_t cycles(RowOf last_row, std::span<const PixelCost> costs,
                                               unsigned units) const noexcept = 0;

    /// Returns the number of rays of a frame with these costs, including those for pixels that the
    /// hardware draws outside the picture.
    [[nodiscard]] virtual std::uint64_t rays(PictureSize size,
                                             std::span<const PixelCost> costs) const noexcept = 0;

    /// How many frames it takes until the picture is complete.
    [[nodiscard]] virtual unsigned frames() const noexcept = 0;
};

/// A picture that was latched to an accelerator's `Frame`.
template <class Frame>
class PictureOf : public Picture
{
  public:
    explicit PictureOf(const Frame& latched) : frame(latched) {}

    const Frame frame; // NOLINT(*-const-or-ref-data-members): a picture is not copied
};

/// The picture must be a PictureOf<Frame>.
template <class Frame>
[[nodiscard]] const Frame& frame_of(const Picture& picture) noexcept
{
    return static_cast<const PictureOf<Frame>&>(picture).frame;
}

/// Draws the same bytes and costs with the vectors of one instruction set. If costs are not wanted,
/// it may skip the work that only they need.
struct Kernel
{
    Isa isa;
    /// Draws the pixels of `region`; keeps all others, and those that this frame does not draw.
    void (*draw)(const Picture& picture, const Region& region, const Canvas& canvas) noexcept;
};

/// One accelerator's computation.
struct Model
{
    const protocol::Accelerator* description;
    std::string_view steps; ///< names in the plural what PixelCost counts
    std::unique_ptr<const Picture> (*latch)(WordSpan words);
    /// The kernels of all instruction sets, or none at all. `draw` is nullptr in a kernel that was
    /// not compiled.
    std::span<const Kernel> (*kernels)() noexcept;
    bool ordered = false; ///< a pixel may depend on earlier ones: pictures are drawn whole
};

} // namespace raymarch::engine
