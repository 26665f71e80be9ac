// SPDX-License-Identifier: MIT
/// @file
/// Pictures to write, and what a folder holds after it.
#pragma once

#include "engine/image.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace raymarch::test
{

/// Which modules this build has: one that is built and not found is a failure, not a test to skip.
inline constexpr bool has_picture_module = RAYMARCH_HAS_PICTURES;
inline constexpr bool has_video_module = RAYMARCH_HAS_VIDEO;

/// Each pixel by `colour(x, y)`.
template <typename Function>
engine::Image picture(engine::PictureSize size, Function colour)
{
    engine::Image image(size);
    for (std::size_t y = 0; y < size.height; ++y)
        for (std::size_t x = 0; x < size.width; ++x) {
            const std::array<std::uint8_t, 3> rgb = colour(x, y);
            std::copy(rgb.begin(), rgb.end(), image.row(y).subspan(3 * x).begin());
        }
    return image;
}

inline std::array<std::uint8_t, 3> pixel(const engine::Image& image, std::size_t x, std::size_t y)
{
    const std::size_t at = 3 * (y * image.size.width + x);
    return {image.rgb[at], image.rgb[at + 1], image.rgb[at + 2]};
}

inline std::uint8_t byte(std::size_t value)
{
    return static_cast<std::uint8_t>(value);
}

/// Noise of `colours` colours, the same at each call.
inline engine::Image noise(engine::PictureSize size, std::size_t colours, std::uint32_t seed = 1)
{
    return picture(size, [&](std::size_t, std::size_t) -> std::array<std::uint8_t, 3> {
        seed = seed * 1'664'525U + 1'013'904'223U;
        const std::size_t colour = (seed >> 8) % colours;
        return {byte(colour * 7), byte(255 - colour), byte(colour >> 8)};
    });
}

} // namespace raymarch::test
