// SPDX-License-Identifier: MIT
/// @file
/// Rays against planes: plane_stage.cpp and the second half of nearest_hit.cpp.
#if defined(RAYMARCH_ENGINE_WHITTED_FAST_PLANES) == defined(HWY_TARGET_TOGGLE)
#ifdef RAYMARCH_ENGINE_WHITTED_FAST_PLANES
#undef RAYMARCH_ENGINE_WHITTED_FAST_PLANES
#else
#define RAYMARCH_ENGINE_WHITTED_FAST_PLANES
#endif

#include "engine/whitted/cycles.hpp"
#include "engine/whitted/fast/lanes-inl.hpp"
#include "engine/whitted/fast/rules.hpp"
#include "engine/whitted/fast/spheres-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace raymarch::engine::whitted::fast::HWY_NAMESPACE
{

struct PlaneHit
{
    Mask<I32> any;
    Vec<I32> index;
    Vec<I32> distance;
    Mask<I32> lost; ///< a point that was kept is beyond the bounds
    Vec<I32> cycles;
};

/// The point must be a word.
HWY_INLINE Mask<I32> within_limits(const Plane& plane, const Triple& point)
{
    const auto axis = [](Vec<I32> c, std::uint16_t limit) {
        return hn::Lt(hn::ShiftRight<fraction_bits>(hn::Abs(c)), Set<I32>(limit));
    };
    return hn::And(hn::And(axis(point.x, plane.limits[0]), axis(point.y, plane.limits[1])),
                   axis(point.z, plane.limits[2]));
}

/// The planes in order, for the lanes in `searching`. `from` is where rays are tested from, which
/// kept points move (R1); the points themselves are always from `origin`.
template <typename R, Generation generation>
HWY_INLINE PlaneHit nearest_plane(const Scene& scene, Mask<I32> searching, const Triple& origin,
                                  Triple from, const Triple& direction)
{
    constexpr bool moves = generation == Generation::Reflected && R::has(Defect::MovingOrigin);
    const PlaneColumns& planes = scene.planes;
    PlaneHit hit{.any = no_lanes(),
                 .index = hn::Zero(I32()),
                 .distance = Set<I32>(bounds::word_end),
                 .lost = no_lanes(),
                 .cycles = hn::Zero(I32())};
    for (std::size_t i = 0; i < plane_count; ++i) {
        const Triple normal{Set<I32>(planes.x[i]), Set<I32>(planes.y[i]), Set<I32>(planes.z[i])};
        const Vec<I32> towards = dot(direction, normal);
        const Mask<I32> faces = hn::And(searching, negative(towards));
        if constexpr (R::counts)
            hit.cycles =
                hn::Add(hit.cycles, IfThenElse(negative(towards), Set<I32>(cycles::plane_met),
                                               Set<I32>(cycles::plane_away)));
        if (hn::AllFalse(I32(), faces))
            continue;

        const Real3 normal_{Set<F32>(planes.x_[i]), Set<F32>(planes.y_[i]), Set<F32>(planes.z_[i])};
        const Vec<F32> above = dot(real(from), normal_, hn::Zero(F32()));
        const Vec<I32> height = hn::Sub(
            floor_4096th(hn::Neg(dot(from, normal)), hn::Mul(above, Set<F32>(-1.0F / 4096.0F))),
            Set<I32>(planes.offset[i]));
        const Vec<I32> speed = hn::Neg(hn::ShiftRight<fraction_bits>(towards));
        const Vec<I32> distance = divide_by_negated(height, hn::Max(speed, Set<I32>(1)));
        Mask<I32> nearer = hn::And(faces, hn::And(hn::Gt(distance, Set<I32>(least_plane_distance)),
                                                  hn::Lt(distance, hit.distance)));
        const Plane& plane = scene.frame.planes[i];
        if (moves || plane.bounded) {
            if (hn::AllFalse(I32(), nearer))
                continue;
            const Reached to = point_at(scene, origin, direction, distance);
            if constexpr (moves) {
                hit.lost = hn::Or(hit.lost, hn::And(nearer, to.lost));
                from = IfThenElse(nearer, to.point, from);
            }
            if (plane.bounded)
                nearer = hn::And(nearer, within_limits(plane, to.point));
        }
        hit.any = hn::Or(hit.any, nearer);
        hit.index = IfThenElse(nearer, Set<I32>(i), hit.index);
        hit.distance = IfThenElse(nearer, distance, hit.distance);
    }
    return hit;
}

} // namespace raymarch::engine::whitted::fast::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
