// SPDX-License-Identifier: MIT
/// @file
/// Shadow rays: shadow.cpp for many points at once.
#include "engine/whitted/cycles.hpp"
#include "engine/whitted/fast/lanes-inl.hpp"
#include "engine/whitted/fast/rules.hpp"
#include "engine/whitted/fast/spheres-inl.hpp"

#if defined(RAYMARCH_WHITTED_SHADOW) == defined(HWY_TARGET_TOGGLE) // NOLINT
#ifdef RAYMARCH_WHITTED_SHADOW
#undef RAYMARCH_WHITTED_SHADOW
#else
#define RAYMARCH_WHITTED_SHADOW
#endif

HWY_BEFORE_NAMESPACE();
namespace raymarch::engine::whitted::fast::HWY_NAMESPACE
{

/// From points to the light.
struct Way
{
    Triple direction;
    Ints distance;
    Ints squared;    ///< N, the squared length over 256: its low 32 bits
    Floats squared_; ///< an estimate of it
    Lanes wrapped;   ///< N is more than 36 bits: the direction may be anything but a unit vector
    Lanes lost;      ///< too short, or not even nearly a unit vector
};

HWY_INLINE Way way_to_light(const Triple& point, const Vector& light)
{
    const auto axis = [](Ints from, Word to) {
        return hn::ShiftRight<light_shift>(hn::Sub(all(to.raw()), from));
    };
    const Triple way{axis(point.x, light.x), axis(point.y, light.y), axis(point.z, light.z)};
    const Real3 way_ = real(way);
    Way to{.squared = dot(way, way), .squared_ = dot(way_, way_, hn::Zero(reals))};
    const Floats estimate = hn::Mul(to.squared_, all(1.0F / 4096.0F));
    SquaredLength squared = squared_length(to.squared, estimate);
    to.wrapped = hn::Not(squared.fits);
    to.lost = squared.too_short;
    if (HWY_UNLIKELY(!none(to.wrapped))) {
        // The root takes the lower 24 bits of what it gets.
        squared.whole = hn::And(squared.whole, all((1 << 24) - 1));
        constexpr float longest = bounds::wrapped_direction * bounds::wrapped_direction - 1;
        to.lost = lanes_of(hn::Or(hn::Lt(real(squared.whole), all(16.0F)),
                                  hn::Gt(estimate, hn::Mul(real(squared.whole), all(longest)))));
    }
    const Ints n = square_root(squared.whole);
    to.direction = divide(way, n);
    to.distance = hn::ShiftLeft<light_shift>(n);
    return to;
}

struct Shadow
{
    Lanes blocked;
    Ints cycles;
};

/// tca <= distance, or (tca - distance)^2 < h: the sphere stands before the light.
HWY_INLINE Lanes enters_before(const Approached& exact, Ints distance)
{
    const Lanes beyond = hn::Gt(exact.along, distance);
    if (HWY_LIKELY(none(beyond)))
        return hn::Not(beyond);
    const Ints excess = hn::Sub(exact.along, distance);
    const Floats excess_ = real(excess);
    const Floats difference = hn::Sub(hn::Mul(excess_, excess_), exact.half_chord_);
    const Lanes inside = negative(hn::Sub(hn::Mul(excess, excess), exact.half_chord),
                                  hn::Mul(difference, all(1.0F / 4096.0F)));
    return either(hn::Not(beyond), inside);
}

/// Which of the points in `searching` a sphere keeps the light from. `own` is the sphere that each
/// is on, or what the original takes for it (R2).
template <typename R, Length length>
HWY_INLINE Shadow search_shadow(const Scene& scene, Lanes searching, const Triple& point,
                                const Way& way, Ints own)
{
    const SphereColumns& spheres = scene.spheres;
    const Approaching ray = approaching(scene, point, way.direction);
    Shadow shadow{.blocked = no_lanes(), .cycles = hn::Zero(words)};
    for (std::size_t i = 0; i < scene.frame.last; ++i) {
        if (none(searching))
            break;
        const Estimate to = estimate(spheres, i, ray);
        const Lanes own_one = hn::Eq(own, all(static_cast<std::int32_t>(i)));
        if constexpr (!R::counts && length == Length::Unit) {
            Lanes passes = to.passes();
            if constexpr (R::has(Defect::ShadowDistance)) // its own sphere blocks even where missed
                passes = choose_lanes(own_one, negative(hn::BitCast(words, to.along)), passes);
            if (none(without(searching, passes)))
                continue;
        }
        const Approached exact = approach<length>(spheres, i, ray, to);
        Lanes blocks{};
        Ints spent = hn::Zero(words);
        if constexpr (R::has(Defect::ShadowDistance)) {
            // Too far: L - r > dl^2, in squared lengths (R5).
            const Floats far_ = hn::Add(hn::Sub(hn::MulAdd(way.squared_, all(256.0F), to.gap),
                                                all(spheres.squared_radius_[i])),
                                        all(spheres.radius_[i]));
            const Ints far = hn::Sub(
                hn::Add(hn::ShiftLeft<2 * light_shift>(way.squared), all(spheres.radius[i])),
                exact.squared_distance);
            const Lanes too_far = negative(far, hn::Mul(far_, all(1.0F / 4096.0F)));
            const Lanes within = either(own_one, from_inside(spheres, i, to, exact));
            blocks = without(either(within, hn::Not(exact.misses)), either(too_far, exact.behind));
            if constexpr (R::counts) {
                const bool at_the_end = i + 1U == scene.frame.last;
                spent = choose(too_far,
                               all(cycles::too_far + (at_the_end ? cycles::too_far_at_the_end : 0)),
                               choose(exact.behind, all(cycles::behind),
                                      choose(within, all(cycles::blocked_within),
                                             choose(exact.misses, all(cycles::missed),
                                                    all(cycles::blocked)))));
            }
        } else {
            const Lanes behind = either(exact.behind, own_one);
            blocks = without(enters_before(exact, way.distance), either(exact.misses, behind));
            if constexpr (R::counts)
                spent = choose(behind, all(cycles::behind),
                               choose(blocks, all(cycles::blocked), all(cycles::missed)));
        }
        if constexpr (R::counts)
            shadow.cycles = hn::Add(shadow.cycles, hn::IfThenElseZero(searching, spent));
        blocks = both(blocks, searching);
        shadow.blocked = either(shadow.blocked, blocks);
        searching = without(searching, blocks);
    }
    return shadow;
}

} // namespace raymarch::engine::whitted::fast::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
