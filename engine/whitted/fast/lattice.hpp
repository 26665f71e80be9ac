// SPDX-License-Identifier: MIT
/// @file
/// Where the samples of a tile lie, which pixels each of them belongs to, and the way from samples
/// to pixels: pixel.cpp and ray_setup.cpp for kernels. Nothing in it depends on the vectors.
#pragma once

#include "engine/model.hpp"
#include "engine/whitted/fast/scene.hpp"
#include "engine/whitted/fast/stream.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace raymarch::engine::whitted::fast
{

/// The samples of up to tile_width pixels of a row, in half pixels. Columns and rows of pixels have
/// even numbers, those between them odd ones. Where pixels are neighbours they share the odd ones.
class Lattice
{
  public:
    /// Columns of one parity.
    struct Part
    {
        std::size_t first;
        std::size_t end;
    };
    struct Row
    {
        int v = 0; ///< half pixels from the top
        Word y;    ///< of the screen, from the eye
        bool wanted = false;
    };

    /// The pixels of `region`'s columns from `x` on.
    Lattice(const Frame& frame, const Region& region, unsigned x) noexcept;

    /// On to the row of pixels `y`: says which rows of samples it wants besides those that it
    /// shares with the one before.
    void move_to(const Frame& frame, unsigned y) noexcept;

    /// The columns that are sampled in a row.
    [[nodiscard]] std::span<const Part> parts_of(std::size_t row) const noexcept;

    /// Traces what the kernel gave up, by the reference.
    void draw_lost(const Frame& frame, Results& results) const noexcept;

    void put_pixels(const Results& results, const Canvas& canvas) const noexcept;
    void put_costs(const Results& results, const Canvas& canvas) const noexcept;

    /// Columns: those of pixels first, then the odd ones.
    alignas(64) std::array<std::int32_t, row_samples + longest_vector> x{}; ///< of the screen
    Word z;
    std::array<Row, sample_rows> rows; ///< odd, even (the pixels'), odd

  private:
    static constexpr std::size_t odd_columns = tile_width; ///< the first of them

    /// Where the samples (-1, 0 or 1) beside pixel i stand in a row.
    [[nodiscard]] std::size_t column_of(std::size_t pixel, int dx) const noexcept
    {
        return dx == 0 ? pixel : odd_columns + pixel * odd_stride_ + (dx > 0 ? 1 : 0);
    }
    [[nodiscard]] std::size_t slot_of(std::size_t pixel, int dx, int dy) const noexcept
    {
        return (dy == 0 ? 1U : row_of_[dy > 0 ? 1 : 0]) * row_samples + column_of(pixel, dx);
    }

    PictureSize size_;
    unsigned first_pixel_;
    unsigned step_;
    std::size_t pixels_;
    std::size_t odd_stride_; ///< 1 where neighbours share columns, else 2
    AntiAliasing anti_aliasing_;
    Defects defects_;
    unsigned y_ = 0;
    std::array<int, row_samples> u_{};        ///< half pixels from the left
    std::array<std::size_t, 2> row_of_{0, 2}; ///< above and below the pixels
    std::array<Part, 2> both_{}, even_{}, odd_{};
    bool begun_ = false;
};

/// Regions that no ray needs to be traced for, and those that only the reference draws.
[[nodiscard]] bool drawn_without_rays(const Scene& scene, const Region& region,
                                      const Canvas& canvas) noexcept;

} // namespace raymarch::engine::whitted::fast
