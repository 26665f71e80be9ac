// SPDX-License-Identifier: MIT
/// @file
/// The checkerboard of the controller (source 001, section VIII): half of the pixels a frame.
#pragma once

#include <cstdint>

namespace raymarch::engine::fractal
{

/// With two buffers that take turns, a buffer has both halves after this many frames.
inline constexpr unsigned checkerboard_frames = 4;

/// True if frame number `frame` draws pixel (x, y). The halves come as 0 1 1 0, so that each of the
/// two buffers gets one after the other.
[[nodiscard]] constexpr bool in_half(std::uint32_t frame, unsigned x, unsigned y) noexcept
{
    const std::uint32_t odd = (frame ^ (frame >> 1)) & 1;
    return ((x + y + odd) & 1) != 0;
}

} // namespace raymarch::engine::fractal
