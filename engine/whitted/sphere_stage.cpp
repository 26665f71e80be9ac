// SPDX-License-Identifier: MIT
#include "engine/whitted/sphere_stage.hpp"

#include "engine/whitted/arithmetic.hpp"

namespace raymarch::engine::whitted
{

Approach approach(const Vector& from, const Vector& direction, const Sphere& sphere) noexcept
{
    const Vector to_centre = sphere.centre - from;
    const Wide squared_distance = dot(to_centre, to_centre);
    const Wide projected = dot(direction, to_centre);
    const Word along = narrow<Word>(projected);
    return {.squared_distance = squared_distance,
            .from_inside = squared_distance < sphere.squared_radius,
            .behind = projected < Wide{},
            .along = along,
            .half_chord = along * along - squared_distance + sphere.squared_radius};
}

Word distance_to_surface(const Approach& to) noexcept
{
    const Word half = root_of(to.half_chord);
    return to.from_inside ? to.along + half : to.along - half;
}

Vector sphere_normal(const Sphere& sphere, const Vector& point) noexcept
{
    return scale(point - sphere.centre, sphere.inverse_radius);
}

} // namespace raymarch::engine::whitted
