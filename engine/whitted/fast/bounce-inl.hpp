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

/// The surfaces that were hit. Rows of the tables are merged, so that spheres and planes in one
/// vector are shaded together from here on.
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

/// The light that reaches surfaces.
struct Lighting
{
    Triple colour;
    Mask<I32> lost;
    Vec<I32> cycles; ///< the search for shadows takes them
};

/// Lights the points in `where`; `own` is that of search_shadow.
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

/// Stores the samples that end.
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

HWY_INLINE void add(Vec<I32>& count, Mask<I32> where, std::uint32_t number)
{
    count = hn::Add(count, hn::IfThenElseZero(where, Set<I32>(number)));
}

/// The spheres and planes that rays hit.
struct Hits
{
    Mask<I32> on_sphere; ///< the light among them
    Mask<I32> on_plane;
    Vec<I32> sphere;
    Vec<I32> plane;
    Vec<I32> distance;
    Mask<I32> lost;
    Vec<I32> cycles;
};

template <typename R, Generation generation>
HWY_INLINE Hits find_hits(const Scene& scene, Mask<I32> here, const Triple& origin,
                          const Triple& direction, Vec<I32> own)
{
    Approaching ray = approaching(scene, origin, direction);
    const SphereHit sphere = nearest_sphere<R, generation>(scene, ray, own);
    Hits hits{.on_sphere = hn::And(sphere.any, here),
              .on_plane = no_lanes(),
              .sphere = sphere.index,
              .plane = hn::Zero(I32()),
              .distance = sphere.distance,
              .lost = hn::And(sphere.lost, here),
              .cycles = sphere.cycles};
    if (!scene.frame.planes_drawn)
        return hits;
    const Mask<I32> open = hn::AndNot(hits.on_sphere, here);
    if (hn::AllFalse(I32(), open))
        return hits;
    const PlaneHit plane = nearest_plane<R, generation>(scene, open, origin, ray.from, direction);
    hits.on_plane = hn::And(plane.any, open);
    hits.plane = plane.index;
    hits.distance = IfThenElse(hits.on_plane, plane.distance, hits.distance);
    hits.lost = hn::Or(hits.lost, hn::And(plane.lost, open));
    if constexpr (R::counts)
        hits.cycles = hn::Add(hits.cycles, hn::IfThenElseZero(open, plane.cycles));
    return hits;
}

/// The sum with the light of the rays that end at it.
template <Generation generation>
HWY_INLINE Vec<I32> with_light(Vec<I32> sum, Mask<I32> at_light, Vec<I32> weight)
{
    constexpr std::int32_t flags =
        Packed::ends_at_light | (generation == Generation::Primary ? Packed::sees_light : 0);
    if (hn::AllFalse(I32(), at_light))
        return sum;
    const Vec<I32> white = Set<I32>(brightest);
    const Vec<I32> brighter = accumulated(sum, {white, white, white}, weight);
    return IfThenElse(at_light, hn::Or(brighter, Set<I32>(flags)), sum);
}

/// The light that the surfaces in `where` reflect.
template <typename R>
HWY_INLINE Lighting shade(const Scene& scene, Mask<I32> where, Mask<I32> lost, Mask<I32> lit_sphere,
                          const Triple& point, const Surface& surface, Vec<I32> own)
{
    // What is black is black in the light too, and in most rooms it is the walls.
    const Mask<I32> coloured =
        R::counts ? where : hn::And(where, positive(any_bit(surface.colour)));
    if (hn::AllFalse(I32(), coloured))
        return {.colour = surface.colour, .lost = no_lanes(), .cycles = hn::Zero(I32())};
    return lighting<R>(scene, hn::AndNot(lost, coloured), lit_sphere, point, surface, own);
}

/// Rays as the stream holds them.
struct Rays
{
    Triple origin;
    Triple direction;
    Vec<I32> own; ///< the sphere that a ray leaves, or saw last (R2)
    Vec<I32> weight;
    Vec<I32> sum;
    Vec<I32> slot;
    Vec<I32> cycles; ///< only where costs are counted, as the next one
    Vec<I32> count;
};

template <typename R, Generation generation>
HWY_INLINE Rays load_rays(const Frame& frame, const Stream<R::counts>& stream, std::size_t at)
{
    constexpr bool primary = generation == Generation::Primary;
    const auto load = [&](const StreamColumn& column) {
        return hn::Load(I32(), column.data() + at);
    };
    const Vec<I32> zero = hn::Zero(I32());
    Rays rays{
        .origin = {Set<I32>(frame.eye.x.raw()), Set<I32>(frame.eye.y.raw()),
                   Set<I32>(frame.eye.z.raw())},
        .direction = {load(stream.direction_x), load(stream.direction_y), load(stream.direction_z)},
        .own = zero,
        .weight = Set<I32>(full_weight),
        .sum = zero,
        .slot = load(stream.slot)};
    if constexpr (!primary) {
        rays.origin = {load(stream.origin_x), load(stream.origin_y), load(stream.origin_z)};
        rays.own = load(stream.sphere);
        rays.weight = load(stream.weight);
        rays.sum = load(stream.sum);
    }
    return rays;
}

/// Appends the rays in `kept` to the first `at` of the stream. Returns how many they are.
template <typename R>
HWY_INLINE std::size_t keep(Stream<R::counts>& stream, std::size_t at, const Rays& rays,
                            Mask<I32> kept)
{
    const Compress<I32> compress(kept);
    const auto put = [&](StreamColumn& column, Vec<I32> value) {
        compress.store(value, column.data() + at);
    };
    put(stream.direction_x, rays.direction.x);
    put(stream.direction_y, rays.direction.y);
    put(stream.direction_z, rays.direction.z);
    put(stream.origin_x, rays.origin.x);
    put(stream.origin_y, rays.origin.y);
    put(stream.origin_z, rays.origin.z);
    put(stream.sphere, rays.own);
    put(stream.weight, rays.weight);
    put(stream.sum, rays.sum);
    put(stream.slot, rays.slot);
    if constexpr (R::counts) {
        put(stream.cycles, rays.cycles);
        put(stream.rays, rays.count);
    }
    return compress.count();
}

/// What samples cost so far; zero where that is not counted.
struct Counts
{
    Vec<I32> cycles;
    Vec<I32> rays;

    template <typename R>
    HWY_INLINE void shaded(Mask<I32> surfaces, Mask<I32> lit_sphere, Vec<I32> search)
    {
        if constexpr (R::counts) {
            cycles = hn::Add(cycles, search);
            add(cycles, surfaces,
                whitted::cycles::ray + whitted::cycles::normal + whitted::cycles::cosine);
            add(cycles, lit_sphere, whitted::cycles::lambert);
            add(rays, surfaces, 1);
        }
    }
    template <typename R>
    HWY_INLINE void reflected(Mask<I32> going_on)
    {
        if constexpr (R::counts) {
            add(cycles, going_on, whitted::cycles::reflect + whitted::cycles::ray);
            add(rays, going_on, 1);
        }
    }
};

template <typename R, Generation generation>
HWY_INLINE Counts counts_of(const Stream<R::counts>& stream, std::size_t at, const Hits& hits)
{
    Counts counts{.cycles = hn::Zero(I32()), .rays = hn::Zero(I32())};
    if constexpr (R::counts && generation == Generation::Primary)
        counts = {Set<I32>(cycles::ray + cycles::end_of_sample), Set<I32>(1)};
    else if constexpr (R::counts)
        counts = {hn::Load(I32(), stream.cycles.data() + at),
                  hn::Load(I32(), stream.rays.data() + at)};
    if constexpr (R::counts) {
        counts.cycles = hn::Add(counts.cycles, hits.cycles);
        add(counts.cycles, hn::Or(hits.on_sphere, hits.on_plane), cycles::accumulate);
    }
    return counts;
}

/// Follows `count` rays of `stream` to what they hit, and leaves their reflections in it. Returns
/// how many those are. `last`: no more reflections.
template <typename R, Generation generation>
std::size_t follow(const Scene& scene, Stream<R::counts>& stream, std::size_t count, bool last,
                   Results& results)
{
    std::size_t kept = 0;
    for (std::size_t at = 0; at < count; at += lanes<I32>) {
        const Mask<I32> here = hn::FirstN(I32(), count - at);
        const Rays from = load_rays<R, generation>(scene.frame, stream, at);
        const Hits hits =
            find_hits<R, generation>(scene, here, from.origin, from.direction, from.own);
        const Mask<I32> at_light =
            hn::And(hits.on_sphere, hn::Eq(hits.sphere, Set<I32>(scene.frame.last)));
        const Mask<I32> lit_sphere = hn::AndNot(at_light, hits.on_sphere);
        const Mask<I32> surfaces = hn::Or(lit_sphere, hits.on_plane);
        const Reached to = point_at(scene, from.origin, from.direction, hits.distance);
        Mask<I32> lost = hn::Or(hits.lost, hn::And(surfaces, to.lost));
        Counts spent = counts_of<R, generation>(stream, at, hits);
        Vec<I32> sum = with_light<generation>(from.sum, at_light, from.weight);
        Vec<I32> weight = from.weight;
        Vec<I32> own = from.own;
        Triple direction = from.direction;
        Mask<I32> going_on = no_lanes();
        if (!hn::AllFalse(I32(), surfaces)) {
            const Surface surface =
                surface_of(scene, lit_sphere, hits.sphere, hits.on_plane, hits.plane, to.point);
            lost = hn::Or(lost, hn::And(surfaces, surface.lost));
            own = IfThenElse(lit_sphere, hits.sphere,
                             R::has(Defect::StaleSphere) ? own : Set<I32>(no_sphere));
            const Lighting light =
                shade<R>(scene, surfaces, lost, lit_sphere, to.point, surface, own);
            lost = hn::Or(lost, light.lost);
            sum = IfThenElse(surfaces, accumulated(sum, light.colour, weight), sum);
            weight = weighted(weight, surface.reflect);
            spent.template shaded<R>(surfaces, lit_sphere, light.cycles);
            if (!last) {
                const Mask<I32> dim = hn::Lt(weight, Set<I32>(least_weight));
                const Mask<I32> bright = hn::AndNot(lost, hn::AndNot(dim, surfaces));
                const Reflected reflected = reflect(direction, surface.normal);
                lost = hn::Or(lost, hn::And(bright, reflected.lost));
                going_on = hn::AndNot(reflected.lost, bright);
                direction = reflected.direction;
                spent.template reflected<R>(going_on);
            }
        }
        finish<R>(results, hn::AndNot(going_on, here), from.slot, sum, spent.cycles, spent.rays);
        lose(results, lost, from.slot);
        if (!hn::AllFalse(I32(), going_on))
            kept += keep<R>(
                stream, kept,
                {to.point, direction, own, weight, sum, from.slot, spent.cycles, spent.rays},
                going_on);
    }
    return kept;
}

} // namespace raymarch::engine::whitted::fast::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
