// SPDX-License-Identifier: MIT
/// @file
/// The display stage (source 001, section VI): from grey to colour.
#pragma once

#include <array>
#include <cstdint>

namespace raymarch::engine::fractal
{

using Rgb = std::array<std::uint8_t, 3>;
/// The colour of each of the sixteen greys. Channels have four bits: 17 times 0 to 15.
using Palette = std::array<Rgb, 16>;

enum class Colouring : std::uint8_t { Grey, Hue };

/// All greys in one hue, a 256th of a turn a step; it turns over greys as well as over `hue`.
[[nodiscard]] Palette palette(Colouring colouring, std::uint8_t hue) noexcept;

} // namespace raymarch::engine::fractal
