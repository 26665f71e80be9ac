// SPDX-License-Identifier: MIT
/// @file
/// The inverse square law of both designs.
#pragma once

#include "engine/sphere/frame.hpp"

#include <cstdint>

namespace raymarch::engine::sphere
{

/// |b - a|^2; differences are taken to 32 bits, which cuts none of a scene in range.
[[nodiscard]] constexpr std::uint64_t squared_distance(const Point& a, const Point& b) noexcept
{
    const auto square = [](std::int32_t from, std::int32_t to) {
        const auto difference = static_cast<std::int32_t>(static_cast<std::uint32_t>(to) -
                                                          static_cast<std::uint32_t>(from));
        return static_cast<std::uint64_t>(std::int64_t{difference} * difference);
    };
    return square(a.x, b.x) + square(a.y, b.y) + square(a.z, b.z); // at most 3 * 2^62
}

/// power / squared, towards zero; nothing at the light itself, where the sources leave it open.
[[nodiscard]] constexpr std::int64_t falloff(std::int64_t power, std::uint64_t squared) noexcept
{
    if (squared == 0)
        return 0;
    const auto magnitude = static_cast<std::uint64_t>(power < 0 ? -power : power) / squared;
    return power < 0 ? -static_cast<std::int64_t>(magnitude) : static_cast<std::int64_t>(magnitude);
}

} // namespace raymarch::engine::sphere
