// SPDX-License-Identifier: MIT
/// @file
/// Rays against planes: plane_stage.cpp and the second half of nearest_hit.cpp.
#include "engine/whitted/cycles.hpp"
#include "engine/whitted/fast/lanes-inl.hpp"
#include "engine/whitted/fast/rules.hpp"
#include "engine/whitted/fast/spheres-inl.hpp"

#if defined(RAYMARCH_WHITTED_PLANES) == defined(HWY_TARGET_TOGGLE) // NOLINT
#ifdef RAYMARCH_WHITTED_PLANES
#undef RAYMARCH_WHITTED_PLANES
#else
#define RAYMARCH_WHITTED_PLANES
#endif

HWY_BEFORE_NAMESPACE();
namespace raymarch::engine::whitted::fast::HWY_NAMESPACE
{

struct PlaneHit
{
    Lanes any;
    Ints index;
    Ints distance;
    Lanes lost; ///< a point that was kept is beyond the bounds
    Ints cycles;
};

/// Of a point that is a word.
HWY_INLINE Lanes within_limits(const Plane& plane, const Triple& point)
{
    const auto axis = [](Ints c, std::uint16_t limit) {
        return hn::Lt(hn::ShiftRight<fraction_bits>(hn::Abs(c)),
                      all(static_cast<std::int32_t>(limit)));
    };
    return both(both(axis(point.x, plane.limits[0]), axis(point.y, plane.limits[1])),
                axis(point.z, plane.limits[2]));
}

/// The planes in order, for the lanes in `searching`. `from` is where rays are tested from, which
/// kept points move (R1); the points themselves are always from `origin`.
template <typename R, Generation generation>
HWY_INLINE PlaneHit nearest_plane(const Scene& scene, Lanes searching, const Triple& origin,
                                  Triple from, const Triple& direction)
{
    constexpr bool moves = generation == Generation::Reflected && R::has(Defect::MovingOrigin);
    const PlaneColumns& planes = scene.planes;
    PlaneHit hit{.any = no_lanes(),
                 .index = hn::Zero(words),
                 .distance = all(bounds::word_end),
                 .lost = no_lanes(),
                 .cycles = hn::Zero(words)};
    for (std::size_t i = 0; i < plane_count; ++i) {
        const Triple normal{all(planes.x[i]), all(planes.y[i]), all(planes.z[i])};
        const Ints towards = dot(direction, normal);
        const Lanes faces = both(searching, negative(towards));
        if constexpr (R::counts)
            hit.cycles = hn::Add(hit.cycles, choose(negative(towards), all(cycles::plane_met),
                                                    all(cycles::plane_away)));
        if (none(faces))
            continue;

        const Real3 normal_{all(planes.x_[i]), all(planes.y_[i]), all(planes.z_[i])};
        const Floats above = dot(real(from), normal_, hn::Zero(reals));
        const Ints height =
            hn::Sub(floor_4096th(hn::Neg(dot(from, normal)), hn::Mul(above, all(-1.0F / 4096.0F))),
                    all(planes.offset[i]));
        const Ints speed = hn::Neg(hn::ShiftRight<fraction_bits>(towards));
        const Ints distance = divide_by_negated(height, hn::Max(speed, all(1)));
        Lanes nearer = both(faces, both(hn::Gt(distance, all(least_plane_distance)),
                                        hn::Lt(distance, hit.distance)));
        const Plane& plane = scene.frame.planes[i];
        if (moves || plane.bounded) {
            if (none(nearer))
                continue;
            const Reached to = point_at(scene, origin, direction, distance);
            if constexpr (moves) {
                hit.lost = either(hit.lost, both(nearer, to.lost));
                from = choose(nearer, to.point, from);
            }
            if (plane.bounded)
                nearer = both(nearer, within_limits(plane, to.point));
        }
        hit.any = either(hit.any, nearer);
        hit.index = choose(nearer, all(static_cast<std::int32_t>(i)), hit.index);
        hit.distance = choose(nearer, distance, hit.distance);
    }
    return hit;
}

} // namespace raymarch::engine::whitted::fast::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
