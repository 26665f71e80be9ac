// SPDX-License-Identifier: MIT
/// @file
/// Which part of a row a sphere can be seen in: the rest misses it, and need not be looked at.
#pragma once

#include "engine/sphere/frame.hpp"
#include "engine/sphere/ray_sphere_unit.hpp"

#include <cstdint>

namespace raymarch::engine::sphere::fast
{

/// Columns from `first` on, before `end`.
struct Span
{
    std::int32_t first;
    std::int32_t end;
};

/// The columns of `of` in row y that may hit the ball; all others of `of` miss it. May be empty.
[[nodiscard]] Span silhouette(const Rules& rules, const Frame& frame, const Ball& ball,
                              std::int32_t y, Span of) noexcept;

} // namespace raymarch::engine::sphere::fast
