// SPDX-License-Identifier: MIT
#include "pictures/sheet.hpp"

#include "pictures/area_scale.hpp"
#include "pictures/small_font.hpp"

#include <algorithm>
#include <cassert>
#include <cstdint>
#include <limits>
#include <string_view>

namespace raymarch::pictures
{
namespace
{

using engine::bytes_per_pixel;
using engine::Image;
using engine::PictureSize;

// In dots of the font.
constexpr std::size_t advance = glyph_width + 1;
constexpr std::size_t space_above_text = 3;
constexpr std::string_view cut_mark = "..";

struct Point
{
    std::size_t x;
    std::size_t y;
};

std::uint16_t length(std::size_t pixels)
{
    assert(pixels <= std::numeric_limits<std::uint16_t>::max());
    return static_cast<std::uint16_t>(pixels);
}

std::size_t caption_height(const SheetLayout& layout)
{
    return layout.text_scale * (space_above_text + glyph_height);
}

std::size_t columns_of(std::size_t entries, const SheetLayout& layout)
{
    if (layout.columns > 0)
        return layout.columns;
    std::size_t columns = 1;
    while (columns * columns < entries)
        ++columns;
    return columns;
}

void fill(Image& sheet, Point at, PictureSize size, const Colour& colour)
{
    for (std::size_t y = at.y; y < at.y + size.height; ++y)
        for (std::size_t x = at.x; x < at.x + size.width; ++x)
            std::copy(colour.begin(), colour.end(),
                      sheet.row(y).subspan(x * bytes_per_pixel).begin());
}

void place(Image& sheet, Point at, const Image& image)
{
    const std::size_t row_bytes = bytes_per_pixel * image.size.width;
    for (std::size_t y = 0; y < image.size.height; ++y)
        std::copy_n(&image.rgb[y * row_bytes], row_bytes,
                    sheet.row(at.y + y).subspan(at.x * bytes_per_pixel).begin());
}

/// As much of the text as `letters` have room for.
std::string shortened(const std::string& text, std::size_t letters)
{
    if (text.size() <= letters)
        return text;
    const std::string_view mark = cut_mark.substr(0, std::min(letters, cut_mark.size()));
    return text.substr(0, letters - mark.size()).append(mark);
}

void write(Image& sheet, Point at, std::string_view text, const SheetLayout& layout)
{
    const std::size_t scale = layout.text_scale;
    for (std::size_t i = 0; i < text.size(); ++i)
        for (std::size_t y = 0; y < glyph_height; ++y)
            for (std::size_t x = 0; x < glyph_width; ++x)
                if (has_dot(text[i], x, y))
                    fill(sheet, {at.x + (i * advance + x) * scale, at.y + y * scale},
                         {layout.text_scale, layout.text_scale}, layout.text);
}

/// Without the gap behind the last letter.
std::size_t text_width(std::size_t letters, std::size_t scale)
{
    return letters == 0 ? 0 : (letters * advance - 1) * scale;
}

void draw_caption(Image& sheet, Point cell, const std::string& caption, const SheetLayout& layout)
{
    const std::size_t scale = layout.text_scale;
    if (scale == 0)
        return;
    const std::size_t letters = (layout.cell.width / scale + 1) / advance;
    const std::string text = shortened(caption, letters);
    write(sheet,
          {cell.x + (layout.cell.width - text_width(text.size(), scale)) / 2,
           cell.y + layout.cell.height + space_above_text * scale},
          text, layout);
}

void draw_picture(Image& sheet, Point cell, const Image& image, const SheetLayout& layout)
{
    if (image.rgb.empty() || layout.cell.width == 0 || layout.cell.height == 0)
        return;
    const PictureSize size = size_in_cell(image.size, layout.cell);
    const auto room = [](std::size_t all, std::size_t taken) { return (all - taken) / 2; };
    place(sheet,
          {cell.x + room(layout.cell.width, size.width),
           cell.y + room(layout.cell.height, size.height)},
          size == image.size ? image : area_scaled(image, size));
}

} // namespace

PictureSize size_in_cell(PictureSize picture, PictureSize cell)
{
    constexpr std::size_t least_enlargement = 4;
    const std::size_t width = picture.width;
    const std::size_t height = picture.height;
    const std::size_t factor = std::min(cell.width / width, cell.height / height);
    if (factor >= least_enlargement)
        return {length(width * factor), length(height * factor)};
    if (factor >= 1)
        return picture;
    // The side that is too long by more fills the cell; the other is rounded, but never to nothing.
    const auto rounded = [](std::size_t numerator, std::size_t denominator) {
        return length(std::max<std::size_t>(1, (numerator + denominator / 2) / denominator));
    };
    if (width * cell.height >= height * cell.width)
        return {cell.width, rounded(height * cell.width, width)};
    return {rounded(width * cell.height, height), cell.height};
}

PictureSize sheet_size(std::size_t entries, const SheetLayout& layout)
{
    const std::size_t columns = columns_of(entries, layout);
    const std::size_t rows = (entries + columns - 1) / columns;
    const std::size_t row_height = layout.cell.height + caption_height(layout) + layout.gap;
    return {length(layout.gap + columns * (std::size_t{layout.cell.width} + layout.gap)),
            length(layout.gap + rows * row_height)};
}

Image contact_sheet(std::span<const SheetEntry> entries, const SheetLayout& layout)
{
    const std::size_t columns = columns_of(entries.size(), layout);
    Image sheet(sheet_size(entries.size(), layout));
    fill(sheet, {0, 0}, sheet.size, layout.background);
    for (std::size_t i = 0; i < entries.size(); ++i) {
        const Point cell = {
            layout.gap + i % columns * (std::size_t{layout.cell.width} + layout.gap),
            layout.gap + i / columns * (layout.cell.height + caption_height(layout) + layout.gap)};
        draw_picture(sheet, cell, entries[i].image, layout);
        draw_caption(sheet, cell, entries[i].caption, layout);
    }
    return sheet;
}

} // namespace raymarch::pictures
