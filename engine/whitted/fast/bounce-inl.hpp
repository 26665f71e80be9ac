// SPDX-License-Identifier: MIT
/// @file
/// One generation of rays: tracer.cpp and shading.cpp for a stream of samples. Each ray is followed
/// to what it hits; what goes on from there as a reflection stays in the stream, close together.
#if defined(RAYMARCH_ENGINE_WHITTED_FAST_BOUNCE) == defined(HWY_TARGET_TOGGLE)
#ifdef RAYMARCH_ENGINE_WHITTED_FAST_BOUNCE
#undef RAYMARCH_ENGINE_WHITTED_FAST_BOUNCE
#else
#define RAYMARCH_ENGINE_WHITTED_FAST_BOUNCE
#endif

#include "engine/fast/compress-inl.hpp"
#include "engine/whitted/fast/planes-inl.hpp"
#include "engine/whitted/fast/shadow-inl.hpp"
#include "engine/whitted/fast/spheres-inl.hpp"
#include "engine/whitted/fast/stream.hpp"
#include "engine/whitted/nearest_hit.hpp"

HWY_BEFORE_NAMESPACE();
namespace raymarch::engine::whitted::fast::HWY_NAMESPACE
{

/// (value * weight) >> 12, of 12 bits each.
HWY_INLINE Vec<I32> weighted(Vec<I32> value, Vec<I32> weight)
{
    return hn::ShiftRight<fraction_bits>(hn::Mul(value, weight));
}

/// Channels that a hit adds.
HWY_INLINE Triple halved(const Triple& colour)
{
    return {hn::ShiftRight<1>(colour.x), hn::ShiftRight<1>(colour.y), hn::ShiftRight<1>(colour.z)};
}

HWY_INLINE Triple lambert(const Triple& colour, Vec<I32> cosine)
{
    const auto channel = [&](Vec<I32> c) {
        return hn::Add(weighted(c, cosine), hn::ShiftRight<1>(c));
    };
    return {channel(colour.x), channel(colour.y), channel(colour.z)};
}

/// One channel of a packed sum with what a hit adds to it.
template <int shift>
HWY_INLINE Vec<I32> accumulated(Vec<I32> sum, Vec<I32> channel, Vec<I32> weight)
{
    const Vec<I32> so_far = hn::And(hn::ShiftRight<shift>(sum), Set<I32>(Packed::channel_mask));
    return hn::ShiftLeft<shift>(
        hn::Min(hn::Add(so_far, weighted(channel, weight)), Set<I32>(brightest)));
}

HWY_INLINE Vec<I32> accumulated(Vec<I32> sum, const Triple& colour, Vec<I32> weight)
{
    return hn::Or(hn::Or(accumulated<Packed::red>(sum, colour.x, weight),
                         accumulated<Packed::green>(sum, colour.y, weight)),
                  accumulated<Packed::blue>(sum, colour.z, weight));
}

/// What was hit. Rows of the tables are merged, so that spheres and planes in one vector are shaded
/// together from here on.
struct Surface
{
    Mask<I32> on_sphere;
    Triple normal;
    Triple colour;
    Vec<I32> reflect;
    Mask<I32> lost;
};

HWY_INLINE Triple colour_of_plane(const PlaneColumns& planes, Vec<I32> index, const Triple& point)
{
    const Triple colour{of_plane(planes.red, index), of_plane(planes.green, index),
                        of_plane(planes.blue, index)};
    const Vec<I32> squares =
        hn::Xor(hn::ShiftRight<fraction_bits>(point.x), hn::ShiftRight<fraction_bits>(point.z));
    const Mask<I32> light =
        hn::Eq(hn::And(squares, of_plane(planes.checker, index)), hn::Zero(I32()));
    return IfThenElse(light, colour, halved(halved(colour)));
}

HWY_INLINE Surface surface_of(const Scene& scene, Mask<I32> on_sphere, Vec<I32> sphere,
                              Mask<I32> on_plane, Vec<I32> plane, const Triple& point)
{
    const Vec<I32> zero = hn::Zero(I32());
    Surface surface{.on_sphere = on_sphere,
                    .normal = {zero, zero, zero},
                    .colour = {zero, zero, zero},
                    .reflect = zero,
                    .lost = no_lanes()};
    if (!hn::AllFalse(I32(), on_sphere)) {
        const SphereColumns& spheres = scene.spheres;
        const Triple centre{of_sphere(spheres.x, sphere), of_sphere(spheres.y, sphere),
                            of_sphere(spheres.z, sphere)};
        const Triple offset = point - centre;
        surface.lost = hn::Gt(reach_of(offset), of_sphere(spheres.offset_limit, sphere));
        const Vec<I32> inverse = of_sphere(spheres.inverse_radius, sphere);
        surface.normal = {hn::ShiftRight<fraction_bits>(hn::Mul(offset.x, inverse)),
                          hn::ShiftRight<fraction_bits>(hn::Mul(offset.y, inverse)),
                          hn::ShiftRight<fraction_bits>(hn::Mul(offset.z, inverse))};
        surface.colour = {of_sphere(spheres.red, sphere), of_sphere(spheres.green, sphere),
                          of_sphere(spheres.blue, sphere)};
        surface.reflect = of_sphere(spheres.reflect, sphere);
    }
    if (!hn::AllFalse(I32(), on_plane)) {
        const PlaneColumns& planes = scene.planes;
        const Triple normal{of_plane(planes.x, plane), of_plane(planes.y, plane),
                            of_plane(planes.z, plane)};
        surface.normal = IfThenElse(on_plane, normal, surface.normal);
        surface.colour =
            IfThenElse(on_plane, colour_of_plane(planes, plane, point), surface.colour);
        surface.reflect = IfThenElse(on_plane, of_plane(planes.reflect, plane), surface.reflect);
        surface.lost = hn::AndNot(on_plane, surface.lost);
    }
    return surface;
}

/// Rare: out of the way of the others.
template <typename R>
HWY_NOINLINE Shadow search_far_shadow(const Scene& scene, Mask<I32> searching, const Triple& point,
                                      const Way& way, Vec<I32> own)
{
    return search_shadow<R, Length::Wrapped>(scene, searching, point, way, own);
}

/// What reaches surfaces from the light.
struct Lighting
{
    Triple colour;
    Mask<I32> lost;
    Vec<I32> cycles; ///< of the search for shadows
};

/// Of the points in `where`; `own` is as in search_shadow.
template <typename R>
HWY_INLINE Lighting lighting(const Scene& scene, Mask<I32> where, Mask<I32> lit_sphere,
                             const Triple& point, const Surface& surface, Vec<I32> own)
{
    const Way way = way_to_light(point, scene.frame.light);
    const Vec<I32> cosine = dot(way.direction, surface.normal);
    const Mask<I32> away = hn::And(lit_sphere, negative(cosine));
    const Mask<I32> searching = hn::AndNot(hn::Or(away, way.lost), where);
    const Shadow shadow =
        HWY_LIKELY(scene.light_is_near && hn::AllFalse(I32(), hn::And(where, way.wrapped)))
            ? search_shadow<R, Length::Unit>(scene, searching, point, way, own)
            : search_far_shadow<R>(scene, searching, point, way, own);
    const Vec<I32> steps = hn::ShiftRight<fraction_bits>(cosine);
    const Vec<I32> full = Set<I32>(full_weight);
    const Vec<I32> weight =
        R::has(Defect::WrappedHighlight) ? hn::And(steps, full) : hn::Min(steps, full);
    const Triple lit = IfThenElse(lit_sphere, lambert(surface.colour, weight), surface.colour);
    return {.colour = IfThenElse(hn::Or(away, shadow.blocked), halved(surface.colour), lit),
            .lost = hn::And(where, way.lost),
            .cycles = shadow.cycles};
}

/// direction - 2 (direction . normal) normal, of unit length.
struct Reflected
{
    Triple direction;
    Mask<I32> lost;
};

HWY_INLINE Reflected reflect(const Triple& direction, const Triple& normal)
{
    const Vec<I32> twice = hn::ShiftRight<fraction_bits - 1>(dot(direction, normal));
    const auto axis = [&](Vec<I32> d, Vec<I32> n) {
        return hn::Sub(d, hn::ShiftRight<fraction_bits>(hn::Mul(n, twice)));
    };
    const Triple mirrored{axis(direction.x, normal.x), axis(direction.y, normal.y),
                          axis(direction.z, normal.z)};
    // All of it fits into 31 bits.
    const Vec<I32> squared = hn::ShiftRight<fraction_bits>(dot(mirrored, mirrored));
    constexpr std::int32_t least =
        bounds::least_length * bounds::least_length / (1 << fraction_bits);
    return {divide(mirrored, square_root(squared)), hn::Lt(squared, Set<I32>(least))};
}

/// Leaves samples to the reference.
HWY_INLINE void lose(Results& results, Mask<I32> lost, Vec<I32> slot)
{
    if (HWY_LIKELY(hn::AllFalse(I32(), lost)))
        return;
    const Compress<I32> compress(lost);
    compress.store(slot, results.lost + results.lost_count);
    results.lost_count += compress.count();
}

/// Samples that end.
template <typename R>
HWY_INLINE void finish(Results& results, Mask<I32> ended, Vec<I32> slot, Vec<I32> sum,
                       Vec<I32> cycles, Vec<I32> rays)
{
    if (hn::AllFalse(I32(), ended))
        return;
    const Compress<I32> compress(ended);
    Storage<lanes<I32>> slots{};
    compress.store(slot, slots);
    const auto put = [&](std::int32_t* to, Vec<I32> value) {
        Storage<lanes<I32>> values{};
        compress.store(value, values);
        for (std::size_t i = 0; i < compress.count(); ++i)
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
    const Vec<I32> light_index = Set<I32>(frame.last);
    std::size_t kept = 0;
    for (std::size_t at = 0; at < count; at += lanes<I32>) {
        const Mask<I32> here = hn::FirstN(I32(), count - at);
        const auto load = [&](const std::int32_t* column) { return hn::Load(I32(), column + at); };
        const Triple direction{load(stream.direction_x), load(stream.direction_y),
                               load(stream.direction_z)};
        Triple origin{Set<I32>(frame.eye.x.raw()), Set<I32>(frame.eye.y.raw()),
                      Set<I32>(frame.eye.z.raw())};
        Vec<I32> own = hn::Zero(I32());
        Vec<I32> weight = Set<I32>(full_weight);
        Vec<I32> sum = hn::Zero(I32());
        const Vec<I32> slot = load(stream.slot);
        if constexpr (!primary) {
            origin = {load(stream.origin_x), load(stream.origin_y), load(stream.origin_z)};
            own = load(stream.sphere);
            weight = load(stream.weight);
            sum = load(stream.sum);
        }

        // What is hit.
        Approaching ray = approaching(scene, origin, direction);
        const SphereHit sphere = nearest_sphere<R, generation>(scene, ray, own);
        Mask<I32> lost = hn::And(sphere.lost, here);
        const Mask<I32> on_sphere = hn::And(sphere.any, here);
        Mask<I32> on_plane = no_lanes();
        Vec<I32> plane_index = hn::Zero(I32());
        Vec<I32> distance = sphere.distance;
        Vec<I32> spent = sphere.cycles;
        if (frame.planes_drawn) {
            const Mask<I32> open = hn::AndNot(on_sphere, here);
            if (!hn::AllFalse(I32(), open)) {
                const PlaneHit plane =
                    nearest_plane<R, generation>(scene, open, origin, ray.from, direction);
                on_plane = hn::And(plane.any, open);
                plane_index = plane.index;
                distance = IfThenElse(on_plane, plane.distance, distance);
                lost = hn::Or(lost, hn::And(plane.lost, open));
                if constexpr (R::counts)
                    spent = hn::Add(spent, hn::IfThenElseZero(open, plane.cycles));
            }
        }
        const Mask<I32> at_light = hn::And(on_sphere, hn::Eq(sphere.index, light_index));
        const Mask<I32> lit_sphere = hn::AndNot(at_light, on_sphere);
        const Mask<I32> surfaces = hn::Or(lit_sphere, on_plane);
        const Reached to = point_at(scene, origin, direction, distance);
        const Triple& point = to.point;
        lost = hn::Or(lost, hn::And(surfaces, to.lost));

        // Light from the light itself.
        Vec<I32> rays = hn::Zero(I32());
        if constexpr (R::counts)
            spent = hn::Add(spent, hn::IfThenElseZero(hn::Or(on_sphere, on_plane),
                                                      Set<I32>(cycles::accumulate)));
        if (!hn::AllFalse(I32(), at_light)) {
            const Vec<I32> white = Set<I32>(brightest);
            sum = IfThenElse(at_light, accumulated(sum, {white, white, white}, weight), sum);
            const std::int32_t flags = Packed::ends_at_light | (primary ? Packed::sees_light : 0);
            sum = IfThenElse(at_light, hn::Or(sum, Set<I32>(flags)), sum);
        }

        // Light on surfaces, and where it goes.
        Mask<I32> goes_on = no_lanes();
        Triple mirrored = direction;
        Vec<I32> now_own = own;
        if (!hn::AllFalse(I32(), surfaces)) {
            const Surface surface =
                surface_of(scene, lit_sphere, sphere.index, on_plane, plane_index, point);
            lost = hn::Or(lost, hn::And(surfaces, surface.lost));
            if constexpr (R::has(Defect::StaleSphere))
                now_own = IfThenElse(lit_sphere, sphere.index, own);
            else
                now_own = IfThenElse(lit_sphere, sphere.index, Set<I32>(no_sphere));
            Triple colour = surface.colour;
            // What is black is black in the light too, and in most rooms it is the walls.
            const Mask<I32> coloured =
                R::counts ? surfaces : hn::And(surfaces, positive(any_bit(surface.colour)));
            if (!hn::AllFalse(I32(), coloured)) {
                const Lighting light = lighting<R>(scene, hn::AndNot(lost, coloured), lit_sphere,
                                                   point, surface, now_own);
                lost = hn::Or(lost, light.lost);
                colour = light.colour;
                if constexpr (R::counts)
                    spent = hn::Add(spent, light.cycles);
            }
            if constexpr (R::counts) {
                constexpr cycles::Cycles shading = cycles::ray + cycles::normal + cycles::cosine;
                spent = hn::Add(spent, hn::IfThenElseZero(surfaces, Set<I32>(shading)));
                spent = hn::Add(spent, hn::IfThenElseZero(lit_sphere, Set<I32>(cycles::lambert)));
                rays = hn::Add(rays, hn::IfThenElseZero(surfaces, Set<I32>(1)));
            }
            const Vec<I32> brighter = accumulated(sum, colour, weight);
            sum = IfThenElse(surfaces, brighter, sum);
            weight = weighted(weight, surface.reflect);
            if (!last) {
                goes_on = hn::AndNot(hn::Lt(weight, Set<I32>(least_weight)), surfaces);
                goes_on = hn::AndNot(lost, goes_on);
                const Reflected reflected = reflect(direction, surface.normal);
                const Mask<I32> unmirrored = hn::And(goes_on, reflected.lost);
                lost = hn::Or(lost, unmirrored);
                goes_on = hn::AndNot(unmirrored, goes_on);
                mirrored = reflected.direction;
                if constexpr (R::counts) {
                    spent = hn::Add(spent, hn::IfThenElseZero(
                                               goes_on, Set<I32>(cycles::reflect + cycles::ray)));
                    rays = hn::Add(rays, hn::IfThenElseZero(goes_on, Set<I32>(1)));
                }
            }
        }

        if constexpr (R::counts) {
            constexpr cycles::Cycles sample = cycles::ray + cycles::end_of_sample;
            spent = hn::Add(spent, primary ? Set<I32>(sample) : load(stream.cycles));
            rays = hn::Add(rays, primary ? Set<I32>(1) : load(stream.rays));
        }
        finish<R>(results, hn::AndNot(goes_on, here), slot, sum, spent, rays);
        lose(results, lost, slot);
        if (hn::AllFalse(I32(), goes_on))
            continue;
        const Compress<I32> compress(goes_on);
        const auto keep = [&](std::int32_t* column, Vec<I32> value) {
            compress.store(value, column + kept);
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
        kept += compress.count();
    }
    return kept;
}

} // namespace raymarch::engine::whitted::fast::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
