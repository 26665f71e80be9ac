// SPDX-License-Identifier: MIT
/// @file
/// Rays against spheres: sphere_stage.cpp and the first half of nearest_hit.cpp.
///
/// Most rays miss most spheres. An estimate that is never too small tells which of them a vector of
/// rays may hit; only for those the exact numbers are computed. Where costs are counted each sphere
/// has its own, so that all are computed exactly.
#include "engine/whitted/cycles.hpp"
#include "engine/whitted/fast/lanes-inl.hpp"
#include "engine/whitted/fast/rules.hpp"

#if defined(RAYMARCH_WHITTED_SPHERES) == defined(HWY_TARGET_TOGGLE) // NOLINT
#ifdef RAYMARCH_WHITTED_SPHERES
#undef RAYMARCH_WHITTED_SPHERES
#else
#define RAYMARCH_WHITTED_SPHERES
#endif

HWY_BEFORE_NAMESPACE();
namespace raymarch::engine::whitted::fast::HWY_NAMESPACE
{

/// A ray, with what all spheres have in common.
struct Approaching
{
    Triple from;
    Triple direction;
    Real3 twice_from_;
    Real3 direction_; ///< over 4096: of length 1
    Floats start;     ///< -direction . from, and the margin
    Floats squared;   ///< |from|^2, less the margin
};

HWY_INLINE Approaching approaching(const Scene& scene, const Triple& from, const Triple& direction)
{
    Approaching ray{.from = from, .direction = direction};
    const Real3 from_ = real(from);
    ray.twice_from_ = {hn::Add(from_.x, from_.x), hn::Add(from_.y, from_.y),
                       hn::Add(from_.z, from_.z)};
    const Floats unit = all(1.0F / 4096.0F);
    ray.direction_ = {hn::Mul(real(direction.x), unit), hn::Mul(real(direction.y), unit),
                      hn::Mul(real(direction.z), unit)};
    const Floats squared = dot(from_, from_, hn::Zero(reals));
    const Margins& margins = scene.margins;
    const Floats margin = hn::MulAdd(squared, all(margins.along_squared), all(margins.along));
    ray.start = hn::Sub(margin, dot(ray.direction_, from_, hn::Zero(reals)));
    ray.squared = hn::MulAdd(squared, all(1.0F - margins.chord_squared), all(-margins.chord));
    return ray;
}

/// Estimates of a ray and sphere i, none of them too small.
struct Estimate
{
    Floats along;      ///< m over 4096
    Floats gap;        ///< r^2 - L
    Floats half_chord; ///< h, where `along` is not negative
    /// Those that surely pass the sphere, or have it behind: `along` or `half_chord` is negative.
    [[nodiscard]] HWY_INLINE Lanes passes() const
    {
        return negative(hn::BitCast(words, hn::Or(along, half_chord)));
    }
};

HWY_INLINE Estimate estimate(const SphereColumns& spheres, std::size_t i, const Approaching& ray)
{
    const Real3 centre{all(spheres.x_[i]), all(spheres.y_[i]), all(spheres.z_[i])};
    Estimate to{.along = dot(ray.direction_, centre, ray.start)};
    to.gap = dot(ray.twice_from_, centre, hn::Sub(all(spheres.gap[i]), ray.squared));
    to.half_chord = hn::MulAdd(to.along, to.along, to.gap);
    return to;
}

/// How long directions are: unit vectors, or the ways to a light so far off that its squared
/// distance has wrapped. Of those no estimate tells what they miss.
enum class Length : bool { Unit, Wrapped };

/// The exact numbers of Approach.
struct Approached
{
    Lanes behind;          ///< m < 0
    Ints along;            ///< tca
    Ints squared_distance; ///< L, its low 32 bits
    Ints half_chord;       ///< h, its low 32 bits
    Floats half_chord_;    ///< an estimate of it
    Ints chord_4096th;     ///< floor(h / 4096), of a unit direction where !misses
    Lanes misses;          ///< h < 0, or behind
};

/// Where x, with these low 32 bits and this estimate of its 4096th that is good within 2^18, is
/// negative; x may be anything.
HWY_INLINE Lanes negative(Ints low, Floats estimate)
{
    const Floats far = all(1073741824.0F);
    return negative(floor_4096th(low, hn::Max(hn::Min(estimate, far), hn::Neg(far))));
}

template <Length length>
HWY_INLINE Approached approach(const SphereColumns& spheres, std::size_t i, const Approaching& ray,
                               const Estimate& to)
{
    const Triple centre{all(spheres.x[i]), all(spheres.y[i]), all(spheres.z[i])};
    const Triple way = centre - ray.from;
    Approached exact{.along = floor_4096th(dot(ray.direction, way), to.along),
                     .squared_distance = dot(way, way)};
    exact.behind = negative(exact.along);
    if constexpr (length == Length::Wrapped)
        exact.along = wrapped(exact.along);
    exact.half_chord = hn::Add(hn::Sub(hn::Mul(exact.along, exact.along), exact.squared_distance),
                               all(spheres.squared_radius[i]));
    // Nearer than the estimate that began with an inexact `along`.
    const Floats along = real(exact.along);
    exact.half_chord_ = hn::MulAdd(along, along, to.gap);
    const Floats chord_4096th = hn::Mul(exact.half_chord_, all(1.0F / 4096.0F));
    if constexpr (length == Length::Unit) {
        exact.chord_4096th = floor_4096th(exact.half_chord, chord_4096th);
        exact.misses = either(to.passes(), negative(exact.chord_4096th));
    } else {
        exact.chord_4096th = hn::Zero(words);
        exact.misses = negative(exact.half_chord, chord_4096th);
    }
    return exact;
}

/// Where the ray begins inside the sphere: L < r^2.
HWY_INLINE Lanes from_inside(const SphereColumns& spheres, std::size_t i, const Estimate& to,
                             const Approached& exact)
{
    return negative(hn::Sub(exact.squared_distance, all(spheres.squared_radius[i])),
                    hn::Mul(to.gap, all(-1.0F / 4096.0F)));
}

/// The nearest sphere so far, in each lane.
struct SphereHit
{
    Lanes any;
    Ints index;
    Ints distance;
    Lanes lost; ///< a sphere met, or a point that was kept, is beyond the bounds
    Ints cycles;
};

/// What a distance is compared by: `measured` takes it as unsigned (R3).
template <typename R>
HWY_INLINE Ints key_of(Ints distance)
{
    return R::has(Defect::UnsignedDistance) ? hn::And(distance, all((1 << 24) - 1)) : distance;
}

/// A point of rays that were followed to their ends.
struct Reached
{
    Triple point;
    Lanes lost; ///< it is beyond the bounds
};

HWY_INLINE Reached point_at(const Scene& scene, const Triple& origin, const Triple& direction,
                            Ints distance)
{
    const Triple way = scaled(direction, distance);
    Reached to{
        .point = {hn::Add(origin.x, way.x), hn::Add(origin.y, way.y), hn::Add(origin.z, way.z)}};
    const auto beyond = [&](float squared_bound) {
        const Real3 point_ = real(to.point);
        return lanes_of(hn::Gt(dot(point_, point_, hn::Zero(reals)), all(squared_bound)));
    };
    to.lost = beyond(scene.squared_near);
    if (HWY_UNLIKELY(!none(to.lost))) { // whatever is near is a word
        to.point = {wrapped(to.point.x), wrapped(to.point.y), wrapped(to.point.z)};
        to.lost = either(beyond(scene.squared_bound),
                         hn::Gt(reach_of(to.point), all(scene.coordinate_bound)));
    }
    return to;
}

/// The spheres in order; `ray` follows the kept points where they move it (R1). `own` is the sphere
/// that each ray leaves.
template <typename R, Generation generation>
HWY_INLINE SphereHit nearest_sphere(const Scene& scene, Approaching& ray, Ints own)
{
    constexpr bool reflected = generation == Generation::Reflected;
    constexpr bool moves = reflected && R::has(Defect::MovingOrigin);
    constexpr bool skips_own = reflected && !R::has(Defect::StaleSphere);
    const SphereColumns& spheres = scene.spheres;
    const Triple origin = ray.from;
    SphereHit hit{.any = no_lanes(),
                  .index = hn::Zero(words),
                  .distance = hn::Zero(words),
                  .lost = no_lanes(),
                  .cycles = hn::Zero(words)};
    Ints best = all(1 << 24);
    for (std::size_t i = 0; i <= scene.frame.last; ++i) {
        const Estimate to = estimate(spheres, i, ray);
        const Lanes passes = to.passes();
        if constexpr (!R::counts)
            if (every(passes))
                continue;
        const Approached exact = approach<Length::Unit>(spheres, i, ray, to);
        Lanes behind = exact.behind;
        if constexpr (skips_own)
            behind = either(behind, hn::Eq(own, all(static_cast<std::int32_t>(i))));
        const Lanes ahead = hn::Not(either(behind, passes));
        hit.lost = either(hit.lost, both(ahead, hn::Gt(exact.along, all(bounds::along))));
        const Lanes meets = without(ahead, exact.misses);
        if constexpr (R::counts)
            hit.cycles =
                hn::Add(hit.cycles, choose(behind, all(cycles::behind),
                                           choose(meets, all(cycles::hit), all(cycles::missed))));

        const Ints half = square_root(hn::And(exact.chord_4096th, all((1 << 24) - 1)));
        Ints distance = hn::Sub(exact.along, half);
        if constexpr (reflected)
            distance =
                choose(from_inside(spheres, i, to, exact), hn::Add(exact.along, half), distance);
        const Ints key = key_of<R>(distance);
        Lanes nearer = both(meets, hn::Lt(key, best));
        if constexpr (!R::has(Defect::UnsignedDistance))
            nearer = both(nearer, positive(distance));
        hit.any = either(hit.any, nearer);
        hit.index = choose(nearer, all(static_cast<std::int32_t>(i)), hit.index);
        hit.distance = choose(nearer, distance, hit.distance);
        best = choose(nearer, key, best);
        if constexpr (moves) {
            if (none(nearer))
                continue;
            const Reached reached = point_at(scene, origin, ray.direction, distance);
            hit.lost = either(hit.lost, both(nearer, reached.lost));
            ray = approaching(scene, choose(nearer, reached.point, ray.from), ray.direction);
        }
    }
    if constexpr (R::counts)
        hit.cycles = hn::Add(hit.cycles, hn::IfThenElseZero(hit.any, all(cycles::sphere_chosen)));
    return hit;
}

} // namespace raymarch::engine::whitted::fast::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
