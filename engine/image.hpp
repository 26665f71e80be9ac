// SPDX-License-Identifier: MIT
/// @file
/// A picture in memory: rows from the top, three bytes a pixel (red, green, blue), no padding.
#pragma once

#include "protocol/parameters.hpp"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace raymarch::engine
{

using protocol::PictureSize;

inline constexpr std::size_t bytes_per_pixel = 3;

struct Image
{
    PictureSize size{};
    std::vector<std::uint8_t> rgb{};

    Image() = default;
    explicit Image(PictureSize of) : size(of), rgb(bytes_per_pixel * of.width * of.height) {}

    [[nodiscard]] std::span<std::uint8_t> row(std::size_t y) noexcept
    {
        const std::size_t row_bytes = bytes_per_pixel * size.width;
        return std::span(rgb).subspan(y * row_bytes, row_bytes);
    }
};

} // namespace raymarch::engine
