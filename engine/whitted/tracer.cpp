// SPDX-License-Identifier: MIT
#include "engine/whitted/tracer.hpp"

#include "engine/whitted/arithmetic.hpp"
#include "engine/whitted/nearest_hit.hpp"
#include "engine/whitted/plane_stage.hpp"
#include "engine/whitted/shading.hpp"
#include "engine/whitted/shadow.hpp"
#include "engine/whitted/sphere_stage.hpp"

namespace raymarch::engine::whitted
{
namespace
{

/// The looks of a hit.
struct Surface
{
    Vector normal;
    Colour colour; ///< lit and shaded
    Weight reflect;
    cycles::Cycles cycles;
};

/// A sphere is lit by Lambert's law; one that is turned away from the light needs no search.
Surface lit_sphere(const Frame& frame, const Hit& hit) noexcept
{
    const Sphere& sphere = frame.spheres[hit.index];
    const WayToLight way = way_to_light(hit.point, frame.light);
    Surface surface{.normal = sphere_normal(sphere, hit.point),
                    .colour = ambient(sphere.colour),
                    .reflect = sphere.reflect,
                    .cycles = cycles::ray + cycles::normal + cycles::cosine + cycles::lambert};
    const Wide cosine = dot(way.direction, surface.normal);
    if (cosine < Wide{})
        return surface;
    const ShadowSearch search = search_shadow(frame, hit.point, way, hit.index);
    surface.cycles += search.cycles;
    if (!search.blocked) {
        const bool wraps = frame.defects.has(Defect::WrappedHighlight);
        surface.colour = lambert(sphere.colour,
                                 cosine_weight(cosine, wraps ? Highlight::Wraps : Highlight::Held));
    }
    return surface;
}

/// A plane has its full colour wherever the light reaches it.
Surface lit_plane(const Frame& frame, const Hit& hit, std::uint8_t last_sphere) noexcept
{
    const Plane& plane = frame.planes[hit.index];
    const Colour colour = plane_colour(plane, hit.point);
    const WayToLight way = way_to_light(hit.point, frame.light);
    const bool stale = frame.defects.has(Defect::StaleSphere);
    const ShadowSearch search =
        search_shadow(frame, hit.point, way, stale ? last_sphere : no_sphere);
    return {.normal = plane.normal,
            .colour = search.blocked ? ambient(colour) : colour,
            .reflect = plane.reflect,
            .cycles = cycles::ray + cycles::normal + cycles::cosine + search.cycles};
}

/// direction - 2 (direction . normal) normal, of unit length.
Vector reflect(const Vector& direction, const Vector& normal) noexcept
{
    constexpr int doubled = fraction_bits - 1;
    const Word twice = Word::from_raw(dot(direction, normal).raw() >> doubled);
    return normalise(direction - scale(normal, twice));
}

} // namespace

Sample trace(const Frame& frame, const Vector& direction) noexcept
{
    Sample sample{.cost = {.steps = cycles::ray + cycles::end_of_sample, .rays = 1}};
    std::uint8_t last_sphere = 0; // what the original's register holds before the first one
    Ray ray{.origin = frame.eye, .direction = direction};
    Weight weight = full_weight;
    for (unsigned reflections = 0;; ++reflections) {
        const Hit hit = nearest_hit(frame, ray);
        sample.cost.steps += hit.cycles;
        if (hit.what == Hit::What::Nothing || hit.what == Hit::What::EyeInside)
            return sample;
        sample.cost.steps += cycles::accumulate;

        const bool on_sphere = hit.what == Hit::What::Sphere;
        if (on_sphere)
            last_sphere = hit.index;
        if (on_sphere && hit.index == frame.last) {
            sample.colour = accumulate(sample.colour, frame.spheres[frame.last].colour, weight);
            sample.sees_light = reflections == 0;
            sample.ends_at_light = true;
            return sample;
        }

        const Surface surface =
            on_sphere ? lit_sphere(frame, hit) : lit_plane(frame, hit, last_sphere);
        sample.cost.steps += surface.cycles;
        ++sample.cost.rays; // the shadow ray, even where the cosine makes it needless
        sample.colour = accumulate(sample.colour, surface.colour, weight);
        weight = reflected_weight(weight, surface.reflect);
        if (reflections == frame.reflections || weight < least_weight)
            return sample;

        ray = {.origin = hit.point,
               .direction = reflect(ray.direction, surface.normal),
               .reflected = true,
               .leaves = on_sphere ? hit.index : no_sphere};
        sample.cost.steps += cycles::reflect + cycles::ray;
        ++sample.cost.rays;
    }
}

} // namespace raymarch::engine::whitted
