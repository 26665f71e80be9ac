// SPDX-License-Identifier: MIT
/// @file
/// A picture as at most 256 colours and one index a pixel, as GIF wants it.
///
/// Pictures of integer shading often have no more colours than that; then nothing is lost.
#pragma once

#include "engine/image.hpp"

#include <array>
#include <cstdint>
#include <vector>

namespace raymarch::pictures
{

using Colour = std::array<std::uint8_t, 3>; ///< red, green, blue

inline constexpr std::size_t max_palette_colours = 256;

struct IndexedImage
{
    engine::PictureSize size{};
    std::vector<Colour> palette{};       ///< rising in red, then green, then blue; no colour twice
    std::vector<std::uint8_t> indices{}; ///< of the palette, rows from the top
};

/// Up to 256 colours are kept exactly. More are gathered into 256 groups: the group with the
/// greatest squared error along one channel is cut at its mean until there are 256, and each
/// becomes its mean colour. No dithering; the same picture always gives the same bytes.
[[nodiscard]] IndexedImage indexed(const engine::Image& image);

} // namespace raymarch::pictures
