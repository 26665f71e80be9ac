// SPDX-License-Identifier: MIT
/// @file
/// The stages composed: eight words in, a row of pixels out (docs/engine.md).
#pragma once

#include "engine/model.hpp"

#include <cstdint>
#include <span>

namespace raymarch::engine::marcher
{

/// See Model::draw_row. The cycles are those of the scene queries (source 000, Table 7).
std::uint64_t draw_row(std::span<const std::uint32_t> words, RowOf row,
                       std::span<std::uint8_t> pixels) noexcept;

} // namespace raymarch::engine::marcher
