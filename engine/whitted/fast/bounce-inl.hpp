// SPDX-License-Identifier: MIT
/// @file
/// One generation of rays: tracer.cpp and shading.cpp for a stream of samples. Each ray is followed
/// to what it hits; what goes on from there as a reflection stays in the stream, close together.
#include "engine/whitted/fast/planes-inl.hpp"
#include "engine/whitted/fast/shadow-inl.hpp"
#include "engine/whitted/fast/spheres-inl.hpp"
#include "engine/whitted/fast/stream.hpp"
#include "engine/whitted/nearest_hit.hpp"

#if defined(RAYMARCH_WHITTED_BOUNCE) == defined(HWY_TARGET_TOGGLE) // NOLINT
#ifdef RAYMARCH_WHITTED_BOUNCE
#undef RAYMARCH_WHITTED_BOUNCE
#else
#define RAYMARCH_WHITTED_BOUNCE
#endif

HWY_BEFORE_NAMESPACE();
namespace raymarch::engine::whitted::fast::HWY_NAMESPACE
{

/// (value * weight) >> 12, of 12 bits each.
HWY_INLINE Ints weighted(Ints value, Ints weight)
{
    return hn::ShiftRight<fraction_bits>(hn::Mul(value, weight));
}

/// Channels that a hit adds.
HWY_INLINE Triple halved(const Triple& colour)
{
    return {hn::ShiftRight<1>(colour.x), hn::ShiftRight<1>(colour.y), hn::ShiftRight<1>(colour.z)};
}

HWY_INLINE Triple lambert(const Triple& colour, Ints cosine)
{
    const auto channel = [&](Ints c) { return hn::Add(weighted(c, cosine), hn::ShiftRight<1>(c)); };
    return {channel(colour.x), channel(colour.y), channel(colour.z)};
}

/// One channel of a packed sum with what a hit adds to it.
template <int shift>
HWY_INLINE Ints accumulated(Ints sum, Ints channel, Ints weight)
{
    const Ints so_far = hn::And(hn::ShiftRight<shift>(sum), all(Packed::channel_mask));
    return hn::ShiftLeft<shift>(
        hn::Min(hn::Add(so_far, weighted(channel, weight)), all(std::int32_t{brightest})));
}

HWY_INLINE Ints accumulated(Ints sum, const Triple& colour, Ints weight)
{
    return hn::Or(hn::Or(accumulated<Packed::red>(sum, colour.x, weight),
                         accumulated<Packed::green>(sum, colour.y, weight)),
                  accumulated<Packed::blue>(sum, colour.z, weight));
}

/// What was hit. Rows of the tables are merged, so that spheres and planes in one vector are shaded
/// together from here on.
struct Surface
{
    Lanes on_sphere;
    Triple normal;
    Triple colour;
    Ints reflect;
    Lanes lost;
};

HWY_INLINE Triple colour_of_plane(const PlaneColumns& planes, Ints index, const Triple& point)
{
    const Triple colour{of_plane(planes.red, index), of_plane(planes.green, index),
                        of_plane(planes.blue, index)};
    const Ints squares =
        hn::Xor(hn::ShiftRight<fraction_bits>(point.x), hn::ShiftRight<fraction_bits>(point.z));
    const Lanes light = hn::Eq(hn::And(squares, of_plane(planes.checker, index)), hn::Zero(words));
    return choose(light, colour, halved(halved(colour)));
}

HWY_INLINE Surface surface_of(const Scene& scene, Lanes on_sphere, Ints sphere, Lanes on_plane,
                              Ints plane, const Triple& point)
{
    const Ints zero = hn::Zero(words);
    Surface surface{.on_sphere = on_sphere,
                    .normal = {zero, zero, zero},
                    .colour = {zero, zero, zero},
                    .reflect = zero,
                    .lost = no_lanes()};
    if (!none(on_sphere)) {
        const SphereColumns& spheres = scene.spheres;
        const Triple centre{of_sphere(spheres.x, sphere), of_sphere(spheres.y, sphere),
                            of_sphere(spheres.z, sphere)};
        const Triple offset = point - centre;
        surface.lost = hn::Gt(reach_of(offset), of_sphere(spheres.offset_limit, sphere));
        const Ints inverse = of_sphere(spheres.inverse_radius, sphere);
        surface.normal = {hn::ShiftRight<fraction_bits>(hn::Mul(offset.x, inverse)),
                          hn::ShiftRight<fraction_bits>(hn::Mul(offset.y, inverse)),
                          hn::ShiftRight<fraction_bits>(hn::Mul(offset.z, inverse))};
        surface.colour = {of_sphere(spheres.red, sphere), of_sphere(spheres.green, sphere),
                          of_sphere(spheres.blue, sphere)};
        surface.reflect = of_sphere(spheres.reflect, sphere);
    }
    if (!none(on_plane)) {
        const PlaneColumns& planes = scene.planes;
        const Triple normal{of_plane(planes.x, plane), of_plane(planes.y, plane),
                            of_plane(planes.z, plane)};
        surface.normal = choose(on_plane, normal, surface.normal);
        surface.colour = choose(on_plane, colour_of_plane(planes, plane, point), surface.colour);
        surface.reflect = choose(on_plane, of_plane(planes.reflect, plane), surface.reflect);
        surface.lost = without(surface.lost, on_plane);
    }
    return surface;
}

/// Rare: out of the way of the others.
template <typename R>
HWY_NOINLINE Shadow search_far_shadow(const Scene& scene, Lanes searching, const Triple& point,
                                      const Way& way, Ints own)
{
    return search_shadow<R, Length::Wrapped>(scene, searching, point, way, own);
}

/// What reaches surfaces from the light.
struct Lighting
{
    Triple colour;
    Lanes lost;
    Ints cycles; ///< of the search for shadows
};

/// Of the points in `where`; `own` is as in search_shadow.
template <typename R>
HWY_INLINE Lighting lighting(const Scene& scene, Lanes where, Lanes lit_sphere, const Triple& point,
                             const Surface& surface, Ints own)
{
    const Way way = way_to_light(point, scene.frame.light);
    const Ints cosine = dot(way.direction, surface.normal);
    const Lanes away = both(lit_sphere, negative(cosine));
    const Lanes searching = without(where, either(away, way.lost));
    const Shadow shadow = HWY_LIKELY(scene.light_is_near && none(both(where, way.wrapped)))
                              ? search_shadow<R, Length::Unit>(scene, searching, point, way, own)
                              : search_far_shadow<R>(scene, searching, point, way, own);
    const Ints steps = hn::ShiftRight<fraction_bits>(cosine);
    const Ints full = all(std::int32_t{full_weight});
    const Ints weight =
        R::has(Defect::WrappedHighlight) ? hn::And(steps, full) : hn::Min(steps, full);
    const Triple lit = choose(lit_sphere, lambert(surface.colour, weight), surface.colour);
    return {.colour = choose(either(away, shadow.blocked), halved(surface.colour), lit),
            .lost = both(where, way.lost),
            .cycles = shadow.cycles};
}

/// direction - 2 (direction . normal) normal, of unit length.
struct Reflected
{
    Triple direction;
    Lanes lost;
};

HWY_INLINE Reflected reflect(const Triple& direction, const Triple& normal)
{
    const Ints twice = hn::ShiftRight<fraction_bits - 1>(dot(direction, normal));
    const auto axis = [&](Ints d, Ints n) {
        return hn::Sub(d, hn::ShiftRight<fraction_bits>(hn::Mul(n, twice)));
    };
    const Triple mirrored{axis(direction.x, normal.x), axis(direction.y, normal.y),
                          axis(direction.z, normal.z)};
    // All of it fits into 31 bits.
    const Ints squared = hn::ShiftRight<fraction_bits>(dot(mirrored, mirrored));
    constexpr std::int32_t least =
        bounds::least_length * bounds::least_length / (1 << fraction_bits);
    return {divide(mirrored, square_root(squared)), hn::Lt(squared, all(least))};
}

/// Leaves samples to the reference.
HWY_INLINE void lose(Results& results, Lanes lost, Ints slot)
{
    if (HWY_LIKELY(none(lost)))
        return;
    const Packing packing(lost);
    packing.store(slot, results.lost + results.lost_count);
    results.lost_count += packing.count();
}

/// Samples that end.
template <typename R>
HWY_INLINE void finish(Results& results, Lanes ended, Ints slot, Ints sum, Ints cycles, Ints rays)
{
    if (none(ended))
        return;
    const Packing packing(ended);
    Storage<lane_count> slots{};
    packing.store(slot, slots);
    const auto put = [&](std::int32_t* to, Ints value) {
        Storage<lane_count> values{};
        packing.store(value, values);
        for (std::size_t i = 0; i < packing.count(); ++i)
            to[slots[i]] = values[i];
    };
    put(results.sums, sum);
    if constexpr (R::counts) {
        put(results.cycles, cycles);
        put(results.rays, rays);
    }
}

/// Follows `count` rays of `stream` to what they hit, and leaves their reflections in it. Returns
/// how many those are. `last`: no more reflections.
template <typename R, Generation generation>
std::size_t follow(const Scene& scene, Stream<R::counts>& stream, std::size_t count, bool last,
                   Results& results)
{
    constexpr bool primary = generation == Generation::Primary;
    const Frame& frame = scene.frame;
    const Ints light_index = all(std::int32_t{frame.last});
    std::size_t kept = 0;
    for (std::size_t at = 0; at < count; at += lane_count) {
        const Lanes here = hn::FirstN(words, count - at);
        const auto load = [&](const std::int32_t* column) { return hn::Load(words, column + at); };
        const Triple direction{load(stream.direction_x), load(stream.direction_y),
                               load(stream.direction_z)};
        Triple origin{all(frame.eye.x.raw()), all(frame.eye.y.raw()), all(frame.eye.z.raw())};
        Ints own = hn::Zero(words);
        Ints weight = all(std::int32_t{full_weight});
        Ints sum = hn::Zero(words);
        const Ints slot = load(stream.slot);
        if constexpr (!primary) {
            origin = {load(stream.origin_x), load(stream.origin_y), load(stream.origin_z)};
            own = load(stream.sphere);
            weight = load(stream.weight);
            sum = load(stream.sum);
        }

        // What is hit.
        Approaching ray = approaching(scene, origin, direction);
        const SphereHit sphere = nearest_sphere<R, generation>(scene, ray, own);
        Lanes lost = both(sphere.lost, here);
        const Lanes on_sphere = both(sphere.any, here);
        Lanes on_plane = no_lanes();
        Ints plane_index = hn::Zero(words);
        Ints distance = sphere.distance;
        Ints spent = sphere.cycles;
        if (frame.planes_drawn) {
            const Lanes open = without(here, on_sphere);
            if (!none(open)) {
                const PlaneHit plane =
                    nearest_plane<R, generation>(scene, open, origin, ray.from, direction);
                on_plane = both(plane.any, open);
                plane_index = plane.index;
                distance = choose(on_plane, plane.distance, distance);
                lost = either(lost, both(plane.lost, open));
                if constexpr (R::counts)
                    spent = hn::Add(spent, hn::IfThenElseZero(open, plane.cycles));
            }
        }
        const Lanes at_light = both(on_sphere, hn::Eq(sphere.index, light_index));
        const Lanes lit_sphere = without(on_sphere, at_light);
        const Lanes surfaces = either(lit_sphere, on_plane);
        const Reached to = point_at(scene, origin, direction, distance);
        const Triple& point = to.point;
        lost = either(lost, both(surfaces, to.lost));

        // Light from the light itself.
        Ints rays = hn::Zero(words);
        if constexpr (R::counts)
            spent = hn::Add(
                spent, hn::IfThenElseZero(either(on_sphere, on_plane), all(cycles::accumulate)));
        if (!none(at_light)) {
            const Ints white = all(std::int32_t{brightest});
            sum = choose(at_light, accumulated(sum, {white, white, white}, weight), sum);
            const std::int32_t flags = Packed::ends_at_light | (primary ? Packed::sees_light : 0);
            sum = choose(at_light, hn::Or(sum, all(flags)), sum);
        }

        // Light on surfaces, and where it goes.
        Lanes goes_on = no_lanes();
        Triple mirrored = direction;
        Ints now_own = own;
        if (!none(surfaces)) {
            const Surface surface =
                surface_of(scene, lit_sphere, sphere.index, on_plane, plane_index, point);
            lost = either(lost, both(surfaces, surface.lost));
            if constexpr (R::has(Defect::StaleSphere))
                now_own = choose(lit_sphere, sphere.index, own);
            else
                now_own = choose(lit_sphere, sphere.index, all(std::int32_t{no_sphere}));
            Triple colour = surface.colour;
            // What is black is black in the light too, and in most rooms it is the walls.
            const Lanes coloured =
                R::counts ? surfaces : both(surfaces, positive(any_bit(surface.colour)));
            if (!none(coloured)) {
                const Lighting light = lighting<R>(scene, without(coloured, lost), lit_sphere,
                                                   point, surface, now_own);
                lost = either(lost, light.lost);
                colour = light.colour;
                if constexpr (R::counts)
                    spent = hn::Add(spent, light.cycles);
            }
            if constexpr (R::counts) {
                constexpr cycles::Cycles shading = cycles::ray + cycles::normal + cycles::cosine;
                spent = hn::Add(spent, hn::IfThenElseZero(surfaces, all(shading)));
                spent = hn::Add(spent, hn::IfThenElseZero(lit_sphere, all(cycles::lambert)));
                rays = hn::Add(rays, hn::IfThenElseZero(surfaces, all(1)));
            }
            const Ints brighter = accumulated(sum, colour, weight);
            sum = choose(surfaces, brighter, sum);
            weight = weighted(weight, surface.reflect);
            if (!last) {
                goes_on = without(surfaces, hn::Lt(weight, all(std::int32_t{least_weight})));
                goes_on = without(goes_on, lost);
                const Reflected reflected = reflect(direction, surface.normal);
                const Lanes unmirrored = both(goes_on, reflected.lost);
                lost = either(lost, unmirrored);
                goes_on = without(goes_on, unmirrored);
                mirrored = reflected.direction;
                if constexpr (R::counts) {
                    spent = hn::Add(
                        spent, hn::IfThenElseZero(goes_on, all(cycles::reflect + cycles::ray)));
                    rays = hn::Add(rays, hn::IfThenElseZero(goes_on, all(1)));
                }
            }
        }

        if constexpr (R::counts) {
            constexpr cycles::Cycles sample = cycles::ray + cycles::end_of_sample;
            spent = hn::Add(spent, primary ? all(sample) : load(stream.cycles));
            rays = hn::Add(rays, primary ? all(1) : load(stream.rays));
        }
        finish<R>(results, without(here, goes_on), slot, sum, spent, rays);
        lose(results, lost, slot);
        if (none(goes_on))
            continue;
        const Packing packing(goes_on);
        const auto keep = [&](std::int32_t* column, Ints value) {
            packing.store(value, column + kept);
        };
        keep(stream.direction_x, mirrored.x);
        keep(stream.direction_y, mirrored.y);
        keep(stream.direction_z, mirrored.z);
        keep(stream.origin_x, point.x);
        keep(stream.origin_y, point.y);
        keep(stream.origin_z, point.z);
        keep(stream.sphere, now_own);
        keep(stream.weight, weight);
        keep(stream.sum, sum);
        keep(stream.slot, slot);
        if constexpr (R::counts) {
            keep(stream.cycles, spent);
            keep(stream.rays, rays);
        }
        kept += packing.count();
    }
    return kept;
}

} // namespace raymarch::engine::whitted::fast::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
