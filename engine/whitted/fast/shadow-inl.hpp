// SPDX-License-Identifier: MIT
/// @file
/// Shadow rays: shadow.cpp for many points at once.
#if defined(RAYMARCH_ENGINE_WHITTED_FAST_SHADOW) == defined(HWY_TARGET_TOGGLE)
#ifdef RAYMARCH_ENGINE_WHITTED_FAST_SHADOW
#undef RAYMARCH_ENGINE_WHITTED_FAST_SHADOW
#else
#define RAYMARCH_ENGINE_WHITTED_FAST_SHADOW
#endif

#include "engine/whitted/cycles.hpp"
#include "engine/whitted/fast/lanes-inl.hpp"
#include "engine/whitted/fast/rules.hpp"
#include "engine/whitted/fast/spheres-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace raymarch::engine::whitted::fast::HWY_NAMESPACE
{

/// From points to the light.
struct Way
{
    Triple direction;
    Vec<I32> distance;
    Vec<I32> squared;  ///< N, the squared length over 256: its low 32 bits
    Vec<F32> squared_; ///< an estimate of it
    Mask<I32> wrapped; ///< N is more than 36 bits: the direction may be anything but a unit vector
    Mask<I32> lost;    ///< too short, or not even nearly a unit vector
};

HWY_INLINE Way way_to_light(const Triple& point, const Vector& light)
{
    const auto axis = [](Vec<I32> from, Word to) {
        return hn::ShiftRight<light_shift>(hn::Sub(Set<I32>(to.raw()), from));
    };
    const Triple way{axis(point.x, light.x), axis(point.y, light.y), axis(point.z, light.z)};
    const Real3 way_ = real(way);
    Way to{.squared = dot(way, way), .squared_ = dot(way_, way_, hn::Zero(F32()))};
    const Vec<F32> estimate = hn::Mul(to.squared_, Set<F32>(1.0F / 4096.0F));
    SquaredLength squared = squared_length(to.squared, estimate);
    to.wrapped = hn::Not(squared.fits);
    to.lost = squared.too_short;
    if (HWY_UNLIKELY(!hn::AllFalse(I32(), to.wrapped))) {
        // The root takes the lower 24 bits of what it gets.
        squared.whole = hn::And(squared.whole, Set<I32>((1 << 24) - 1));
        constexpr float longest = bounds::wrapped_direction * bounds::wrapped_direction - 1;
        to.lost = hn::RebindMask(
            I32(), hn::Or(hn::Lt(real(squared.whole), Set<F32>(16.0F)),
                          hn::Gt(estimate, hn::Mul(real(squared.whole), Set<F32>(longest)))));
    }
    const Vec<I32> n = square_root(squared.whole);
    to.direction = divide(way, n);
    to.distance = hn::ShiftLeft<light_shift>(n);
    return to;
}

struct Shadow
{
    Mask<I32> blocked;
    Vec<I32> cycles;
};

/// tca <= distance, or (tca - distance)^2 < h: the sphere stands before the light.
HWY_INLINE Mask<I32> enters_before(const Approached& exact, Vec<I32> distance)
{
    const Mask<I32> beyond = hn::Gt(exact.along, distance);
    if (HWY_LIKELY(hn::AllFalse(I32(), beyond)))
        return hn::Not(beyond);
    const Vec<I32> excess = hn::Sub(exact.along, distance);
    const Vec<F32> excess_ = real(excess);
    const Vec<F32> difference = hn::Sub(hn::Mul(excess_, excess_), exact.half_chord_);
    const Mask<I32> inside = negative(hn::Sub(hn::Mul(excess, excess), exact.half_chord),
                                      hn::Mul(difference, Set<F32>(1.0F / 4096.0F)));
    return hn::Or(hn::Not(beyond), inside);
}

/// Which of the points in `searching` a sphere keeps the light from. `own` is the sphere that each
/// is on, or what the original takes for it (R2).
template <typename R, Length length>
HWY_INLINE Shadow search_shadow(const Scene& scene, Mask<I32> searching, const Triple& point,
                                const Way& way, Vec<I32> own)
{
    const SphereColumns& spheres = scene.spheres;
    const Approaching ray = approaching(scene, point, way.direction);
    Shadow shadow{.blocked = no_lanes(), .cycles = hn::Zero(I32())};
    for (std::size_t i = 0; i < scene.frame.last; ++i) {
        if (hn::AllFalse(I32(), searching))
            break;
        const Estimate to = estimate(spheres, i, ray);
        const Mask<I32> own_one = hn::Eq(own, Set<I32>(i));
        if constexpr (!R::counts && length == Length::Unit) {
            Mask<I32> passes = to.passes();
            if constexpr (R::has(Defect::ShadowDistance)) // its own sphere blocks even where missed
                passes = choose_lanes(own_one, negative(hn::BitCast(I32(), to.along)), passes);
            if (hn::AllFalse(I32(), hn::AndNot(passes, searching)))
                continue;
        }
        const Approached exact = approach<length>(spheres, i, ray, to);
        Mask<I32> blocks{};
        Vec<I32> spent = hn::Zero(I32());
        if constexpr (R::has(Defect::ShadowDistance)) {
            // Too far: L - r > dl^2, in squared lengths (R5).
            const Vec<F32> far_ =
                hn::Add(hn::Sub(hn::MulAdd(way.squared_, Set<F32>(256.0F), to.gap),
                                Set<F32>(spheres.squared_radius_[i])),
                        Set<F32>(spheres.radius_[i]));
            const Vec<I32> far = hn::Sub(
                hn::Add(hn::ShiftLeft<2 * light_shift>(way.squared), Set<I32>(spheres.radius[i])),
                exact.squared_distance);
            const Mask<I32> too_far = negative(far, hn::Mul(far_, Set<F32>(1.0F / 4096.0F)));
            const Mask<I32> within = hn::Or(own_one, from_inside(spheres, i, to, exact));
            blocks =
                hn::AndNot(hn::Or(too_far, exact.behind), hn::Or(within, hn::Not(exact.misses)));
            if constexpr (R::counts) {
                const bool at_the_end = i + 1U == scene.frame.last;
                spent = IfThenElse(
                    too_far,
                    Set<I32>(cycles::too_far + (at_the_end ? cycles::too_far_at_the_end : 0)),
                    IfThenElse(exact.behind, Set<I32>(cycles::behind),
                               IfThenElse(within, Set<I32>(cycles::blocked_within),
                                          IfThenElse(exact.misses, Set<I32>(cycles::missed),
                                                     Set<I32>(cycles::blocked)))));
            }
        } else {
            const Mask<I32> behind = hn::Or(exact.behind, own_one);
            blocks = hn::AndNot(hn::Or(exact.misses, behind), enters_before(exact, way.distance));
            if constexpr (R::counts)
                spent = IfThenElse(
                    behind, Set<I32>(cycles::behind),
                    IfThenElse(blocks, Set<I32>(cycles::blocked), Set<I32>(cycles::missed)));
        }
        if constexpr (R::counts)
            shadow.cycles = hn::Add(shadow.cycles, hn::IfThenElseZero(searching, spent));
        blocks = hn::And(blocks, searching);
        shadow.blocked = hn::Or(shadow.blocked, blocks);
        searching = hn::AndNot(blocks, searching);
    }
    return shadow;
}

} // namespace raymarch::engine::whitted::fast::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
