// SPDX-License-Identifier: MIT
/// @file
/// Rays against spheres: sphere_stage.cpp and the first half of nearest_hit.cpp.
///
/// Most rays miss most spheres. An estimate that is never too small tells which of them a vector of
/// rays may hit; only for those the exact numbers are computed. Where costs are counted each sphere
/// has its own, so that all are computed exactly.
#if defined(RAYMARCH_ENGINE_WHITTED_FAST_SPHERES) == defined(HWY_TARGET_TOGGLE)
#ifdef RAYMARCH_ENGINE_WHITTED_FAST_SPHERES
#undef RAYMARCH_ENGINE_WHITTED_FAST_SPHERES
#else
#define RAYMARCH_ENGINE_WHITTED_FAST_SPHERES
#endif

#include "engine/whitted/cycles.hpp"
#include "engine/whitted/fast/lanes-inl.hpp"
#include "engine/whitted/fast/rules.hpp"

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
    Vec<F32> start;   ///< -direction . from, and the margin
    Vec<F32> squared; ///< |from|^2, less the margin
};

HWY_INLINE Approaching approaching(const Scene& scene, const Triple& from, const Triple& direction)
{
    Approaching ray{.from = from, .direction = direction};
    const Real3 from_ = real(from);
    ray.twice_from_ = {hn::Add(from_.x, from_.x), hn::Add(from_.y, from_.y),
                       hn::Add(from_.z, from_.z)};
    const Vec<F32> unit = Set<F32>(1.0F / 4096.0F);
    ray.direction_ = {hn::Mul(real(direction.x), unit), hn::Mul(real(direction.y), unit),
                      hn::Mul(real(direction.z), unit)};
    const Vec<F32> squared = dot(from_, from_, hn::Zero(F32()));
    const Margins& margins = scene.margins;
    const Vec<F32> margin =
        hn::MulAdd(squared, Set<F32>(margins.along_squared), Set<F32>(margins.along));
    ray.start = hn::Sub(margin, dot(ray.direction_, from_, hn::Zero(F32())));
    ray.squared =
        hn::MulAdd(squared, Set<F32>(1.0F - margins.chord_squared), Set<F32>(-margins.chord));
    return ray;
}

/// Estimates of a ray and sphere i, none of them too small.
struct Estimate
{
    Vec<F32> along;      ///< m over 4096
    Vec<F32> gap;        ///< r^2 - L
    Vec<F32> half_chord; ///< h, where `along` is not negative
    /// Those that surely pass the sphere, or have it behind: `along` or `half_chord` is negative.
    [[nodiscard]] HWY_INLINE Mask<I32> passes() const
    {
        return negative(hn::BitCast(I32(), hn::Or(along, half_chord)));
    }
};

HWY_INLINE Estimate estimate(const SphereColumns& spheres, std::size_t i, const Approaching& ray)
{
    const Real3 centre{Set<F32>(spheres.x_[i]), Set<F32>(spheres.y_[i]), Set<F32>(spheres.z_[i])};
    Estimate to{.along = dot(ray.direction_, centre, ray.start)};
    to.gap = dot(ray.twice_from_, centre, hn::Sub(Set<F32>(spheres.gap[i]), ray.squared));
    to.half_chord = hn::MulAdd(to.along, to.along, to.gap);
    return to;
}

/// How long directions are: unit vectors, or the ways to a light so far off that its squared
/// distance has wrapped. Of those no estimate tells what they miss.
enum class Length : bool { Unit, Wrapped };

/// The exact numbers of Approach.
struct Approached
{
    Mask<I32> behind;          ///< m < 0
    Vec<I32> along;            ///< tca
    Vec<I32> squared_distance; ///< L, its low 32 bits
    Vec<I32> half_chord;       ///< h, its low 32 bits
    Vec<F32> half_chord_;      ///< an estimate of it
    Vec<I32> chord_4096th;     ///< floor(h / 4096), of a unit direction where !misses
    Mask<I32> misses;          ///< h < 0, or behind
};

/// Where x, with these low 32 bits and this estimate of its 4096th that is good within 2^18, is
/// negative; x may be anything.
HWY_INLINE Mask<I32> negative(Vec<I32> low, Vec<F32> estimate)
{
    const Vec<F32> far = Set<F32>(1073741824.0F);
    return negative(floor_4096th(low, hn::Max(hn::Min(estimate, far), hn::Neg(far))));
}

template <Length length>
HWY_INLINE Approached approach(const SphereColumns& spheres, std::size_t i, const Approaching& ray,
                               const Estimate& to)
{
    const Triple centre{Set<I32>(spheres.x[i]), Set<I32>(spheres.y[i]), Set<I32>(spheres.z[i])};
    const Triple way = centre - ray.from;
    Approached exact{.along = floor_4096th(dot(ray.direction, way), to.along),
                     .squared_distance = dot(way, way)};
    exact.behind = negative(exact.along);
    if constexpr (length == Length::Wrapped)
        exact.along = wrapped(exact.along);
    exact.half_chord = hn::Add(hn::Sub(hn::Mul(exact.along, exact.along), exact.squared_distance),
                               Set<I32>(spheres.squared_radius[i]));
    // Nearer than the estimate that began with an inexact `along`.
    const Vec<F32> along = real(exact.along);
    exact.half_chord_ = hn::MulAdd(along, along, to.gap);
    const Vec<F32> chord_4096th = hn::Mul(exact.half_chord_, Set<F32>(1.0F / 4096.0F));
    if constexpr (length == Length::Unit) {
        exact.chord_4096th = floor_4096th(exact.half_chord, chord_4096th);
        exact.misses = hn::Or(to.passes(), negative(exact.chord_4096th));
    } else {
        exact.chord_4096th = hn::Zero(I32());
        exact.misses = negative(exact.half_chord, chord_4096th);
    }
    return exact;
}

/// The rays that begin inside the sphere: L < r^2.
HWY_INLINE Mask<I32> from_inside(const SphereColumns& spheres, std::size_t i, const Estimate& to,
                                 const Approached& exact)
{
    return negative(hn::Sub(exact.squared_distance, Set<I32>(spheres.squared_radius[i])),
                    hn::Mul(to.gap, Set<F32>(-1.0F / 4096.0F)));
}

/// The nearest sphere so far, in each lane.
struct SphereHit
{
    Mask<I32> any;
    Vec<I32> index;
    Vec<I32> distance;
    Mask<I32> lost; ///< a sphere met, or a point that was kept, is beyond the bounds
    Vec<I32> cycles;
};

/// Distances are compared by this key: `measured` takes them as unsigned (R3).
template <typename R>
HWY_INLINE Vec<I32> key_of(Vec<I32> distance)
{
    return R::has(Defect::UnsignedDistance) ? hn::And(distance, Set<I32>((1 << 24) - 1)) : distance;
}

/// A point of rays that were followed to their ends.
struct Reached
{
    Triple point;
    Mask<I32> lost; ///< it is beyond the bounds
};

HWY_INLINE Reached point_at(const Scene& scene, const Triple& origin, const Triple& direction,
                            Vec<I32> distance)
{
    const Triple way = scaled(direction, distance);
    Reached to{
        .point = {hn::Add(origin.x, way.x), hn::Add(origin.y, way.y), hn::Add(origin.z, way.z)}};
    const auto beyond = [&](float squared_bound) {
        const Real3 point_ = real(to.point);
        return hn::RebindMask(
            I32(), hn::Gt(dot(point_, point_, hn::Zero(F32())), Set<F32>(squared_bound)));
    };
    to.lost = beyond(scene.squared_near);
    if (HWY_UNLIKELY(!hn::AllFalse(I32(), to.lost))) { // whatever is near is a word
        to.point = {wrapped(to.point.x), wrapped(to.point.y), wrapped(to.point.z)};
        to.lost = hn::Or(beyond(scene.squared_bound),
                         hn::Gt(reach_of(to.point), Set<I32>(scene.coordinate_bound)));
    }
    return to;
}

/// The spheres in order; `ray` follows the kept points where they move it (R1). `own` is the sphere
/// that each ray leaves.
template <typename R, Generation generation>
HWY_INLINE SphereHit nearest_sphere(const Scene& scene, Approaching& ray, Vec<I32> own)
{
    constexpr bool reflected = generation == Generation::Reflected;
    constexpr bool moves = reflected && R::has(Defect::MovingOrigin);
    constexpr bool skips_own = reflected && !R::has(Defect::StaleSphere);
    const SphereColumns& spheres = scene.spheres;
    const Triple origin = ray.from;
    SphereHit hit{.any = no_lanes(),
                  .index = hn::Zero(I32()),
                  .distance = hn::Zero(I32()),
                  .lost = no_lanes(),
                  .cycles = hn::Zero(I32())};
    Vec<I32> best = Set<I32>(1 << 24);
    for (std::size_t i = 0; i <= scene.frame.last; ++i) {
        const Estimate to = estimate(spheres, i, ray);
        const Mask<I32> passes = to.passes();
        if constexpr (!R::counts)
            if (hn::AllTrue(I32(), passes))
                continue;
        const Approached exact = approach<Length::Unit>(spheres, i, ray, to);
        Mask<I32> behind = exact.behind;
        if constexpr (skips_own)
            behind = hn::Or(behind, hn::Eq(own, Set<I32>(i)));
        const Mask<I32> ahead = hn::Not(hn::Or(behind, passes));
        hit.lost = hn::Or(hit.lost, hn::And(ahead, hn::Gt(exact.along, Set<I32>(bounds::along))));
        const Mask<I32> meets = hn::AndNot(exact.misses, ahead);
        if constexpr (R::counts)
            hit.cycles = hn::Add(hit.cycles, IfThenElse(behind, Set<I32>(cycles::behind),
                                                        IfThenElse(meets, Set<I32>(cycles::hit),
                                                                   Set<I32>(cycles::missed))));

        const Vec<I32> half = square_root(hn::And(exact.chord_4096th, Set<I32>((1 << 24) - 1)));
        Vec<I32> distance = hn::Sub(exact.along, half);
        if constexpr (reflected)
            distance = IfThenElse(from_inside(spheres, i, to, exact), hn::Add(exact.along, half),
                                  distance);
        const Vec<I32> key = key_of<R>(distance);
        Mask<I32> nearer = hn::And(meets, hn::Lt(key, best));
        if constexpr (!R::has(Defect::UnsignedDistance))
            nearer = hn::And(nearer, positive(distance));
        hit.any = hn::Or(hit.any, nearer);
        hit.index = IfThenElse(nearer, Set<I32>(i), hit.index);
        hit.distance = IfThenElse(nearer, distance, hit.distance);
        best = IfThenElse(nearer, key, best);
        if constexpr (moves) {
            if (hn::AllFalse(I32(), nearer))
                continue;
            const Reached reached = point_at(scene, origin, ray.direction, distance);
            hit.lost = hn::Or(hit.lost, hn::And(nearer, reached.lost));
            ray = approaching(scene, IfThenElse(nearer, reached.point, ray.from), ray.direction);
        }
    }
    if constexpr (R::counts)
        hit.cycles =
            hn::Add(hit.cycles, hn::IfThenElseZero(hit.any, Set<I32>(cycles::sphere_chosen)));
    return hit;
}

} // namespace raymarch::engine::whitted::fast::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
