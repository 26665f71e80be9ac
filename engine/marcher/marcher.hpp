// SPDX-License-Identifier: MIT
/// @file
/// The stages composed: eight words in, a row of pixels out (docs/engine.md).
#pragma once

#include "engine/marcher/frame.hpp"
#include "engine/model.hpp"

#include <cstdint>
#include <span>

namespace raymarch::engine::marcher
{

/// See Picture::draw. A step is one scene query.
void draw_row(const Frame& frame, RowOf row, std::span<std::uint8_t> pixels,
              std::span<PixelCost> costs) noexcept;

/// See Picture::cycles: the scene queries' cycles (source 000, Table 7), shared out among the
/// units.
std::uint64_t frame_cycles(const Frame& frame, RowOf last_row, std::span<const PixelCost> costs,
                           unsigned units) noexcept;

} // namespace raymarch::engine::marcher
