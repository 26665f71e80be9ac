// SPDX-License-Identifier: MIT
/// @file
/// The stages composed: a frame in, rows of pixels out (docs/engine/whitted.md).
#pragma once

#include "engine/model.hpp"
#include "engine/whitted/frame.hpp"

#include <cstdint>
#include <span>

namespace raymarch::engine::whitted
{

/// See Picture::draw. A step is a clock cycle.
void draw_row(const Frame& frame, RowOf row, std::span<std::uint8_t> pixels,
              std::span<PixelCost> costs) noexcept;

/// See Picture::cycles. The machine has one ray unit; more would share the pixels out evenly.
std::uint64_t frame_cycles(const Frame& frame, RowOf last_row, std::span<const PixelCost> costs,
                           unsigned units) noexcept;

/// See Picture::rays.
std::uint64_t frame_rays(const Frame& frame, PictureSize size,
                         std::span<const PixelCost> costs) noexcept;

/// The sum of a frame's costs.
struct FrameCost
{
    std::uint64_t cycles = 0;
    std::uint64_t rays = 0;
    bool operator==(const FrameCost&) const = default;
};

/// The picture's pixels, those that the original draws beyond it (R9), and the end of the frame.
[[nodiscard]] FrameCost frame_cost(const Frame& frame, PictureSize size,
                                   std::span<const PixelCost> costs) noexcept;

} // namespace raymarch::engine::whitted
