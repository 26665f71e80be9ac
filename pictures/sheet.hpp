// SPDX-License-Identifier: MIT
/// @file
/// A contact sheet: many pictures on one, each in a cell of the same size with a line of text.
#pragma once

#include "engine/image.hpp"
#include "pictures/palette.hpp"

#include <span>
#include <string>

namespace raymarch::pictures
{

struct SheetEntry
{
    engine::Image image;
    std::string caption; ///< printable ASCII; what is too long ends in ".."
};

/// Lengths in pixels.
struct SheetLayout
{
    std::uint16_t columns = 0;          ///< 0: the least whose square is not less than the entries
    engine::PictureSize cell{320, 240}; ///< for the picture; the caption stands below it
    std::uint16_t gap = 12;             ///< around the cells and between them
    std::uint16_t text_scale = 2;       ///< of a dot of the 5x7 letters; 0: no captions
    Colour background{24, 24, 28};
    Colour text{208, 208, 208};
};

/// How large a picture is in a cell, with its aspect kept: as it is when it fits; smaller when it
/// does not; larger only when the cell has room for four times its size or more, by the greatest
/// whole factor. Both are at least 1x1.
[[nodiscard]] engine::PictureSize size_in_cell(engine::PictureSize picture,
                                               engine::PictureSize cell);

/// How large the sheet for so many pictures is. At most 65535 a side (asserted).
[[nodiscard]] engine::PictureSize sheet_size(std::size_t entries, const SheetLayout& layout);

/// Row by row from the top left, pictures and captions in the middle of their cells. A picture
/// without pixels leaves its cell empty.
[[nodiscard]] engine::Image contact_sheet(std::span<const SheetEntry> entries,
                                          const SheetLayout& layout = {});

} // namespace raymarch::pictures
