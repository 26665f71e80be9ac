// SPDX-License-Identifier: MIT
/// @file
/// Reads the size of a picture, `640x480`, or a part of a picture, `64x48+10+20`.
#pragma once

#include "protocol/parameters.hpp"

#include <charconv>
#include <optional>
#include <string_view>

namespace raymarch::protocol
{

/// Reads two decimal numbers joined by `x`, each from 1 to that of `largest`. The result is empty
/// for any other text.
[[nodiscard]] inline std::optional<PictureSize> parse_size(std::string_view text,
                                                           PictureSize largest) noexcept
{
    PictureSize size;
    const char* const end = text.data() + text.size();
    const auto width = std::from_chars(text.data(), end, size.width);
    if (width.ec != std::errc{} || width.ptr == end || *width.ptr != 'x')
        return std::nullopt;
    const auto height = std::from_chars(width.ptr + 1, end, size.height);
    if (height.ec != std::errc{} || height.ptr != end || size.width < 1 || size.height < 1 ||
        size.width > largest.width || size.height > largest.height)
        return std::nullopt;
    return size;
}

/// A rectangle of a picture: its upper left corner and its size.
struct Tile
{
    std::uint16_t x = 0;
    std::uint16_t y = 0;
    PictureSize size;
};

/// Reads a size, then the number of columns to its left and of rows above it. The result is empty
/// for any other text, and for a tile that is not inside the picture.
[[nodiscard]] inline std::optional<Tile> parse_tile(std::string_view text,
                                                    PictureSize picture) noexcept
{
    const std::size_t plus = text.find('+');
    const auto size = parse_size(text.substr(0, plus), picture);
    if (!size || plus == std::string_view::npos)
        return std::nullopt;
    Tile tile{.size = *size};
    const char* const end = text.data() + text.size();
    const auto x = std::from_chars(text.data() + plus + 1, end, tile.x);
    if (x.ec != std::errc{} || x.ptr == end || *x.ptr != '+')
        return std::nullopt;
    const auto y = std::from_chars(x.ptr + 1, end, tile.y);
    if (y.ec != std::errc{} || y.ptr != end || tile.x > picture.width - size->width ||
        tile.y > picture.height - size->height)
        return std::nullopt;
    return tile;
}

} // namespace raymarch::protocol
