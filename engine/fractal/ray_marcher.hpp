// SPDX-License-Identifier: MIT
/// @file
/// The ray marcher stage (source 001, section V.D, Fig. 5, 6): sphere tracing along one ray.
#pragma once

#include "engine/fractal/formats.hpp"
#include "engine/fractal/scenes.hpp"

#include <cstdint>

namespace raymarch::engine::fractal
{

inline constexpr std::uint8_t max_depth = 31; ///< no more steps than five bits count
inline constexpr Number hit_limit = shift_right(hundredth, 1);

/// How a ray ended.
struct March
{
    bool hit = false;
    std::uint8_t depth = 0; ///< steps made, to max_depth; the distance was asked once more
    Point point{};          ///< where it was asked last
};

/// Steps by the distance until it is below 0.005, which is a hit, or above 5, or max_depth steps
/// are made. A ray that starts inside matter hits at once.
[[nodiscard]] March march(const Point& origin, const Point& direction, Distance distance) noexcept;

} // namespace raymarch::engine::fractal
