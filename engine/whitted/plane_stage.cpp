// SPDX-License-Identifier: MIT
#include "engine/whitted/plane_stage.hpp"

#include "engine/whitted/arithmetic.hpp"

namespace raymarch::engine::whitted
{
namespace
{

/// Floored, so that squares are as wide on both sides of 0.
int integer_part(Word c) noexcept
{
    return c.raw() >> fraction_bits;
}

int integer_part_of_magnitude(Word c) noexcept
{
    return (c.raw() < 0 ? -c.raw() : c.raw()) >> fraction_bits;
}

} // namespace

PlaneDistance plane_distance(const Vector& from, const Vector& direction,
                             const Plane& plane) noexcept
{
    const Wide towards = dot(direction, plane.normal);
    const Word speed = narrow<Word>(towards);
    const Word height = narrow<Word>(-dot(from, plane.normal)) - plane.offset;
    if (towards >= Wide{})
        return {.away = true, .speed = speed, .height = height, .distance = {}};
    return {.away = false, .speed = speed, .height = height, .distance = divide(height, speed)};
}

bool counts(Word plane_distance) noexcept
{
    return plane_distance.raw() > least_plane_distance;
}

bool within_limits(const Plane& plane, const Vector& point) noexcept
{
    return integer_part_of_magnitude(point.x) < plane.limits[0] &&
           integer_part_of_magnitude(point.y) < plane.limits[1] &&
           integer_part_of_magnitude(point.z) < plane.limits[2];
}

Colour plane_colour(const Plane& plane, const Vector& point) noexcept
{
    const int differing = integer_part(point.x) ^ integer_part(point.z);
    if ((differing & plane.checker) == 0)
        return plane.colour;
    Colour dark = plane.colour;
    for (std::uint16_t& channel : dark)
        channel = static_cast<std::uint16_t>(channel >> 2);
    return dark;
}

} // namespace raymarch::engine::whitted
