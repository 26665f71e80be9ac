// SPDX-License-Identifier: MIT
#include "engine/fractal/shading.hpp"

namespace raymarch::engine::fractal
{
namespace
{

constexpr unsigned scale_bits = 4; ///< sixteen courses of bricks a unit

Number scaled(Number c) noexcept
{
    return Number::from_raw(std::int64_t{c.raw()} * (1 << scale_bits));
}

/// Positive where `c` is not within a tenth of the middle of 0 to 1.
Number beyond_joint(Number c) noexcept
{
    return absolute(c - half) - tenth;
}

} // namespace

std::uint8_t brick(const Point& p, std::uint8_t depth) noexcept
{
    const Point at = map(p, scaled);
    const bool odd_course = ((at.y - half).raw() & one.raw()) != 0;
    const Number u = fraction(shift_right(at.x, 1) + shift_right(at.z, 1)) +
                     (odd_course ? half : Number{}); // up to 1.5, and left there
    const Number v = fraction(at.y);
    const bool inside = std::min(beyond_joint(u), beyond_joint(v)) > Number{};
    return inside ? (depth - 2) & max_depth : depth;
}

std::uint8_t grey(const Frame& frame, const March& ray, std::uint16_t x, std::uint16_t y) noexcept
{
    constexpr unsigned white = 15;
    if (!ray.hit)
        return 0;
    const unsigned depth = frame.texture ? brick(ray.point, ray.depth) : ray.depth;
    const unsigned level = depth >> 1;
    const bool odd_pixel = ((x ^ y) & 1) != 0;
    const bool darker = frame.dither && depth % 2 != 0 && level != white && odd_pixel;
    return static_cast<std::uint8_t>(white - level - (darker ? 1 : 0));
}

} // namespace raymarch::engine::fractal
