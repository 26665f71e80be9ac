// SPDX-License-Identifier: MIT
/// @file
/// `640x480` to a picture's size.
#pragma once

#include "protocol/parameters.hpp"

#include <charconv>
#include <optional>
#include <string_view>

namespace raymarch::protocol
{

/// Two decimal numbers joined by `x`, each from 1 to that of `largest`; nothing for other text.
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

} // namespace raymarch::protocol
