// SPDX-License-Identifier: MIT
/// @file
/// Where the samples of a tile lie, which pixels each of them belongs to, and the way from samples
/// to pixels: pixel.cpp and ray_setup.cpp for kernels. Nothing in it depends on the vectors.
#pragma once

#include "engine/model.hpp"
#include "engine/whitted/fast/scene.hpp"
#include "engine/whitted/fast/stream.hpp"
#include "engine/whitted/ray_setup.hpp"

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

    void put_costs(const Results& results, const Canvas& canvas) const noexcept;

    /// Columns: those of pixels first, then the odd ones.
    alignas(64) std::array<std::int32_t, row_samples + longest_vector> x{}; ///< of the screen
    Word z;
    std::array<Row, sample_rows> rows; ///< odd, even (the pixels'), odd

    [[nodiscard]] std::size_t pixels() const noexcept { return pixels_; }
    /// The slot of sample `place` of the first pixel; those of the others follow it.
    [[nodiscard]] std::size_t first_slot(const SamplePlace& place) const noexcept
    {
        return (place.dy == 0 ? 1U : row_of_[place.dy > 0 ? 1 : 0]) * row_samples +
               first_column(place.dx);
    }
    /// The place of pixel i in the picture.
    [[nodiscard]] std::size_t at(std::size_t i) const noexcept
    {
        return std::size_t{y_} * size_.width + first_pixel_ + i * step_;
    }
    /// Row 0 of the original (R6).
    [[nodiscard]] bool is_black() const noexcept
    {
        return y_ == 0 && defects_.has(Defect::UnsignedPixel);
    }

  private:
    static constexpr std::size_t odd_columns = tile_width; ///< the first of them

    [[nodiscard]] std::size_t first_column(int dx) const noexcept
    {
        return dx == 0 ? 0 : dx < 0 ? odd_columns : odd_columns + to_the_right_;
    }

    PictureSize size_;
    unsigned first_pixel_;
    unsigned step_;
    std::size_t pixels_;
    std::size_t to_the_right_; ///< from the column left of a pixel to the one right of it
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
