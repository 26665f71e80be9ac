// SPDX-License-Identifier: MIT
/// @file
/// The hardware core: one pixel of one sphere and one light, in 16 shades.
#pragma once

#include "engine/sphere/frame.hpp"
#include "engine/sphere/timeline.hpp"

#include <cstdint>

namespace raymarch::engine::sphere
{

inline constexpr std::int32_t rtl_white = 15;

struct RtlPixel
{
    std::uint8_t value = 0; ///< 0 to 15, the divider being in time
    Outcome outcome = Outcome::Missed;
    Point point; ///< the ray strikes here; a miss has the eye
};

/// The first sphere and the first light count. Precondition: frame is `held`.
[[nodiscard]] RtlPixel rtl_pixel(const Frame& frame, std::int32_t x, std::int32_t y) noexcept;

} // namespace raymarch::engine::sphere
