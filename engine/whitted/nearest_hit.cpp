// SPDX-License-Identifier: MIT
#include "engine/whitted/nearest_hit.hpp"

#include "engine/whitted/plane_stage.hpp"
#include "engine/whitted/sphere_stage.hpp"

namespace raymarch::engine::whitted
{
namespace
{

/// The search as far as it has come.
struct Search
{
    Hit best;
    Vector origin; ///< that spheres and planes are tested from
};

Vector point_at(const Ray& ray, Word distance) noexcept
{
    return ray.origin + scale(ray.direction, distance);
}

/// A point is kept: the original keeps it in the register that reflected rays are tested from (R1).
void keep_point(const Frame& frame, const Ray& ray, const Vector& point, Search& search) noexcept
{
    if (ray.reflected && frame.defects.has(Defect::MovingOrigin))
        search.origin = point;
}

/// Reads an unsigned word, which makes a negative one far away.
std::uint32_t unsigned_word(Word a) noexcept
{
    return static_cast<std::uint32_t>(a.raw()) & ((1U << Word::width) - 1);
}

bool is_nearer(const Frame& frame, Word distance, const Hit& best) noexcept
{
    const bool first = best.what == Hit::What::Nothing;
    if (frame.defects.has(Defect::UnsignedDistance))
        return first || unsigned_word(distance) < unsigned_word(best.distance);
    return distance > Word{} && (first || distance < best.distance);
}

void search_spheres(const Frame& frame, const Ray& ray, Search& search) noexcept
{
    Hit& best = search.best;
    const bool skips_own = !frame.defects.has(Defect::StaleSphere);
    for (std::uint8_t i = 0; i <= frame.last; ++i) {
        const Approach to = approach(search.origin, ray.direction, frame.spheres[i]);
        if (to.from_inside && !ray.reflected) {
            best.what = Hit::What::EyeInside;
            best.cycles += cycles::eye_inside;
            return;
        }
        if (to.behind || (skips_own && i == ray.leaves)) {
            best.cycles += cycles::behind;
            continue;
        }
        if (to.half_chord < Wide{}) {
            best.cycles += cycles::missed;
            continue;
        }
        best.cycles += cycles::hit;
        const Word distance = distance_to_surface(to);
        if (is_nearer(frame, distance, best)) {
            best.what = Hit::What::Sphere;
            best.index = i;
            best.distance = distance;
            best.point = point_at(ray, distance);
            keep_point(frame, ray, best.point, search);
        }
    }
    if (best.what == Hit::What::Sphere)
        best.cycles += cycles::sphere_chosen;
}

void search_planes(const Frame& frame, const Ray& ray, Search& search) noexcept
{
    Hit& best = search.best;
    for (std::uint8_t i = 0; i < plane_count; ++i) {
        const Plane& plane = frame.planes[i];
        const PlaneDistance to = plane_distance(search.origin, ray.direction, plane);
        if (to.away) {
            best.cycles += cycles::plane_away;
            continue;
        }
        best.cycles += cycles::plane_met;
        const bool nearer = best.what == Hit::What::Nothing || to.distance < best.distance;
        if (!counts(to.distance) || !nearer)
            continue;
        const Vector point = point_at(ray, to.distance);
        keep_point(frame, ray, point, search);
        if (plane.bounded && !within_limits(plane, point))
            continue;
        best.what = Hit::What::Plane;
        best.index = i;
        best.distance = to.distance;
        best.point = point;
    }
}

} // namespace

Hit nearest_hit(const Frame& frame, const Ray& ray) noexcept
{
    Search search{.best = {}, .origin = ray.origin};
    search_spheres(frame, ray, search);
    if (search.best.what == Hit::What::Nothing && frame.planes_drawn)
        search_planes(frame, ray, search);
    return search.best;
}

} // namespace raymarch::engine::whitted
