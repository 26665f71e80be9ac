// SPDX-License-Identifier: MIT
#include "engine/whitted/shadow.hpp"

#include "engine/whitted/arithmetic.hpp"
#include "engine/whitted/sphere_stage.hpp"

namespace raymarch::engine::whitted
{
namespace
{

/// Says what one sphere does to the shadow ray.
struct Obstacle
{
    bool blocks;
    cycles::Cycles cycles;
};

/// The original's test. A radius is taken from a squared distance (R5), and what is nearer in this
/// sense blocks even without a shadow if it is the stale sphere (R2).
Obstacle obstacle_as_measured(const Sphere& sphere, const Approach& to, const WayToLight& way,
                              bool own, bool at_the_end) noexcept
{
    if (to.squared_distance - sphere.radius > way.squared_distance)
        return {false, cycles::too_far + (at_the_end ? cycles::too_far_at_the_end : 0)};
    if (to.behind)
        return {false, cycles::behind};
    if (own || to.from_inside)
        return {true, cycles::blocked_within};
    if (to.half_chord < Wide{})
        return {false, cycles::missed};
    return {true, cycles::blocked};
}

/// True if the ray enters the sphere before it reaches the light: along - sqrt(half_chord) <
/// distance, without the root.
bool enters_before(const Approach& to, Word distance) noexcept
{
    const Word beyond = to.along - distance;
    return to.along <= distance || beyond * beyond < to.half_chord;
}

Obstacle obstacle(const Approach& to, const WayToLight& way, bool own) noexcept
{
    if (to.behind || own)
        return {false, cycles::behind};
    if (to.half_chord < Wide{} || !enters_before(to, way.distance))
        return {false, cycles::missed};
    return {true, cycles::blocked};
}

} // namespace

WayToLight way_to_light(const Vector& point, const Vector& light) noexcept
{
    const Vector way = map(light - point, [](Word c) { return shift_right(c, light_shift); });
    const Wide squared = dot(way, way);
    const Word n = root_of(squared);
    constexpr std::int32_t unit = 1 << light_shift;
    constexpr std::int64_t squared_unit = 1 << (2 * light_shift);
    return {.direction = map(way, [=](Word c) { return divide(c, n); }),
            .distance = Word::from_raw(n.raw() * unit),
            .squared_distance = Wide::from_raw(squared.raw() * squared_unit)};
}

ShadowSearch search_shadow(const Frame& frame, const Vector& point, const WayToLight& way,
                           std::uint8_t own) noexcept
{
    ShadowSearch search;
    for (std::uint8_t i = 0; i < frame.last && !search.blocked; ++i) {
        const Sphere& sphere = frame.spheres[i];
        const Approach to = approach(point, way.direction, sphere);
        const Obstacle found =
            frame.defects.has(Defect::ShadowDistance)
                ? obstacle_as_measured(sphere, to, way, i == own, i + 1 == frame.last)
                : obstacle(to, way, i == own);
        search.blocked = found.blocks;
        search.cycles += found.cycles;
    }
    return search;
}

} // namespace raymarch::engine::whitted
