// SPDX-License-Identifier: MIT
/// @file
/// Rays under way, one column a number, and where the samples that they end in go.
#pragma once

#include "engine/whitted/formats.hpp"

#include <array>
#include <cstddef>
#include <cstdint>

namespace raymarch::engine::whitted::fast
{

/// Pixels of a row that are drawn together.
inline constexpr unsigned tile_width = 128;
/// Samples of a row of them: of the pixels' columns, and of those to the left and right.
inline constexpr std::size_t row_samples = std::size_t{3} * tile_width;
/// Rows of samples that a row of pixels needs.
inline constexpr std::size_t sample_rows = 3;
/// Neighbours share samples, so that a stream holds two rows of all that a tile's pixels have.
inline constexpr std::size_t stream_length = 2 * (std::size_t{2} * tile_width + 1);
/// So many columns more are there than are used, as vectors are stored whole.
inline constexpr std::size_t longest_vector = 16;

/// A sample's colour and what it saw, in 32 bits.
struct Packed
{
    static constexpr int red = 0;
    static constexpr int green = 10;
    static constexpr int blue = 20;
    static constexpr std::int32_t channel_mask = brightest;
    static constexpr std::int32_t sees_light = 1 << 30;
    static constexpr std::int32_t ends_at_light = -1 - 0x7FFF'FFFF; ///< the sign
};

template <std::size_t length>
struct alignas(64) Storage : std::array<std::int32_t, length>
{
    // NOLINTNEXTLINE(google-explicit-constructor): a column is used as its first element
    operator std::int32_t*() noexcept { return this->data(); }
};

using StreamColumn = Storage<stream_length + longest_vector>;

template <bool counts>
struct Stream
{
    StreamColumn direction_x, direction_y, direction_z;
    StreamColumn origin_x, origin_y, origin_z; ///< only of reflected rays, as all below but slot
    StreamColumn sphere;                       ///< that the ray leaves, or saw last (R2)
    StreamColumn weight;
    StreamColumn sum;
    StreamColumn slot; ///< of Results
};

template <>
struct Stream<true> : Stream<false>
{
    StreamColumn cycles, rays;
};

/// Samples by their slots: row * row_samples + column.
struct Results
{
    static constexpr std::size_t slots = sample_rows * row_samples;

    Storage<slots + longest_vector> sums;
    Storage<slots + longest_vector> lost; ///< those that are left to the reference
    std::size_t lost_count = 0;
    Storage<slots> cycles; ///< only where they are counted
    Storage<slots> rays;
};

} // namespace raymarch::engine::whitted::fast
