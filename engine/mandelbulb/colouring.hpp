// SPDX-License-Identifier: MIT
/// @file
/// TABLE: the colours by evaluations of the ray, and by the index of its last iteration (the
/// source has a ROM of 25 x 24 bits, §V.C).
#pragma once

#include "engine/mandelbulb/frame.hpp"

#include <array>
#include <cstddef>
#include <cstdint>

namespace raymarch::engine::mandelbulb
{

using Rgb = std::uint32_t; ///< 0xRRGGBB

// Eight a line, from the background over blue and green to white.
// clang-format off
inline constexpr std::array<Rgb, 32> step_colours = {
    0x05070c, 0x181048, 0x171e5a, 0x162e6e, 0x163f83, 0x154d95, 0x145da9, 0x146ebe,
    0x1a7cba, 0x218bb7, 0x289bb4, 0x2ea9b0, 0x35b8ad, 0x3cc8aa, 0x59cb9d, 0x7ace8f,
    0x9bd282, 0xb8d575, 0xd9d867, 0xfadc5a, 0xf6c750, 0xf3b146, 0xf09b3c, 0xec8632,
    0xe97028, 0xe65a1e, 0xe9723e, 0xee8c61, 0xf2a784, 0xf6bfa4, 0xfadac7, 0xfff5eb,
};

inline constexpr std::array<Rgb, 25> index_colours = {
    0x05070c, 0x181048, 0x17235f, 0x163779, 0x154c93, 0x1460ad, 0x1775bc, 0x1f88b8,
    0x289cb3, 0x31b0af, 0x3ac3aa, 0x5ccb9c, 0x86cf8a, 0xacd37a, 0xd6d869, 0xf9d758,
    0xf5bb4b, 0xf09f3d, 0xec8230, 0xe76623, 0xe96d37, 0xee8f64, 0xf4b191, 0xf9d3be,
    0xfff5eb,
};
// clang-format on

/// The colour of a ray that hit, or came to its limit; a miss has entry 0 of either table.
[[nodiscard]] constexpr Rgb colour_of(ColourMode mode, int evaluations, int index) noexcept
{
    if (mode == ColourMode::Steps) {
        const int last = static_cast<int>(step_colours.size()) - 1;
        return step_colours[static_cast<std::size_t>(std::clamp(evaluations / 2, 1, last))];
    }
    // More than 25 iterations begin again behind the background.
    const int shown = static_cast<int>(index_colours.size()) - 1;
    return index_colours[static_cast<std::size_t>(index <= 0 ? 1 : 1 + (index - 1) % shown)];
}

} // namespace raymarch::engine::mandelbulb
