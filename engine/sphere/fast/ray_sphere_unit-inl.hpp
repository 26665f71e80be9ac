// SPDX-License-Identifier: MIT
/// @file
/// The unit of ray_sphere_unit.hpp in vectors of double, which hold integers of 53 bits: as long as
/// no number of a line is larger every step here is exact, and the lines beyond that are said to be
/// inexact, for the reference to compute. Compiled once for each instruction set.
#if defined(RAYMARCH_ENGINE_SPHERE_FAST_RAY_SPHERE_UNIT) == defined(HWY_TARGET_TOGGLE)
#ifdef RAYMARCH_ENGINE_SPHERE_FAST_RAY_SPHERE_UNIT
#undef RAYMARCH_ENGINE_SPHERE_FAST_RAY_SPHERE_UNIT
#else
#define RAYMARCH_ENGINE_SPHERE_FAST_RAY_SPHERE_UNIT
#endif

#include "engine/sphere/ray_sphere_unit.hpp"

#include <hwy/highway.h>

#include <cstdint>

HWY_BEFORE_NAMESPACE();
namespace raymarch::engine::sphere::HWY_NAMESPACE
{

namespace hn = hwy::HWY_NAMESPACE;

/// Integers.
using Real = hn::ScalableTag<double>;
using RealVec = hn::Vec<Real>;
using RealMask = hn::Mask<Real>;

/// Not Vec3, whose members would be compiled without the vectors' instructions.
struct Points
{
    RealVec x;
    RealVec y;
    RealVec z;
};

HWY_INLINE RealVec real(std::int64_t value)
{
    return hn::Set(Real(), static_cast<double>(value));
}

HWY_INLINE Points points(const Point& p)
{
    return {real(p.x), real(p.y), real(p.z)};
}

HWY_INLINE Points difference(const Points& a, const Points& b)
{
    return {hn::Sub(a.x, b.x), hn::Sub(a.y, b.y), hn::Sub(a.z, b.z)};
}

HWY_INLINE RealVec dot(const Points& a, const Points& b)
{
    return hn::Add(hn::Mul(a.x, b.x), hn::Add(hn::Mul(a.y, b.y), hn::Mul(a.z, b.z)));
}

/// Whether |v| <= 2^bits. False of what is no number.
HWY_INLINE RealMask fits(RealVec v, int bits)
{
    return hn::Le(hn::Abs(v), real(std::int64_t{1} << bits));
}

/// As Rules, for the compiler to know.
enum class RuleSet : std::uint8_t { Rtl, Repaired, Prototype, Corrected };

/// Where lines meet a sphere; a line without a bit in `hits` has no point.
struct Strikes
{
    RealMask misses; ///< those that neither miss nor hit are rejected
    RealMask hits;
    RealMask exact;  ///< where the rest holds
    RealVec squared; ///< the squared length of the line
    RealVec root;
    Points point;
};

/// Of integers, towards zero. Exact for |a| <= 2^52 and |a| + |b| < 2^53: a quotient that is not an
/// integer is farther from the next one, by more than 2^-53 of it, than it is rounded.
HWY_INLINE RealVec quotient(RealVec a, RealVec b)
{
    return hn::Trunc(hn::Div(a, b));
}

/// A coordinate as it leaves the unit; `exact` loses those for which that takes more than a double.
template <RuleSet rules>
HWY_INLINE RealVec narrowed(RealVec v, RealMask& exact)
{
    constexpr std::int64_t limit = 1 << 17;
    if constexpr (rules == RuleSet::Corrected)
        return hn::Min(hn::Max(v, real(-limit)), real(limit - 1));
    if constexpr (rules == RuleSet::Prototype) {
        exact = hn::And(exact, fits(v, 17)); // and the low 32 bits are all
        return v;
    }
    const RealVec word = real(1 << 16);
    return hn::Sub(v, hn::Mul(word, hn::Floor(hn::Mul(v, hn::Set(Real(), 0x1p-16)))));
}

/// intersect(), of coordinates up to 2^17. `beside` is from - centre, and `c` its squared length
/// less the squared radius.
template <RuleSet rules, Reach reach>
HWY_INLINE Strikes intersect(const Points& from, const Points& to, const Points& beside, RealVec c,
                             std::int32_t derounder)
{
    constexpr bool hardware = rules == RuleSet::Rtl || rules == RuleSet::Repaired;
    Strikes strikes;
    // Differences are below 2^18.6, so these are below 2^40.
    const Points along = difference(to, from);
    const RealVec a = dot(along, along);
    const RealVec half_b = dot(along, beside);

    // A quarter of the discriminant: exact where both products are, which then are below 2^51.
    const RealVec first = hn::Mul(half_b, half_b);
    const RealVec second = hn::Mul(a, c);
    const RealVec discriminant = hn::Sub(first, second);
    strikes.exact = hn::And(fits(first, 49), fits(second, 49));
    if constexpr (rules == RuleSet::Prototype) // coefficients of 32 bits are not cut
        strikes.exact =
            hn::And(strikes.exact, hn::And(fits(a, 30), hn::And(fits(half_b, 29), fits(c, 30))));
    strikes.misses = hardware ? hn::Le(discriminant, real(0)) : hn::Lt(discriminant, real(0));
    strikes.squared = a;
    strikes.hits = hn::Not(strikes.misses);
    if (hn::AllFalse(Real(), strikes.hits))
        return strikes;

    // Below 2^52 the root of a double has the same floor as the root itself, in both designs.
    const RealVec root = hn::Floor(hn::Sqrt(hn::Mul(discriminant, real(4))));
    const RealVec shift = derounder == 0 ? real(0) : quotient(a, real(derounder));
    const RealVec middle = hn::Sub(hn::Mul(half_b, real(-2)), shift);
    const RealVec far = hn::Add(middle, root);
    const RealVec near = hn::Sub(middle, root);
    const RealVec whole = hn::Add(a, a);
    const RealVec threshold = real(reach == Reach::Segment ? segment_threshold : 0);

    const auto too_near = [&](RealVec t) {
        // Without a sign a negative T is a huge one.
        return rules == RuleSet::Rtl ? hn::And(hn::Ge(t, real(0)), hn::Lt(t, threshold))
                                     : hn::Lt(t, threshold);
    };
    const auto too_far = [&](RealVec t) {
        return reach == Reach::Segment ? hn::Gt(t, whole) : hn::MaskFromVec(real(0));
    };
    RealVec used = near;
    RealMask rejected = hn::Eq(a, real(0));
    if constexpr (rules == RuleSet::Corrected) {
        const RealMask near_out = hn::Or(too_near(near), too_far(near));
        const RealMask far_out = hn::Or(too_near(far), too_far(far));
        rejected = hn::Or(rejected, hn::And(near_out, far_out));
        used = hn::IfThenElse(near_out, far, near);
    } else {
        rejected = hn::Or(rejected, hn::Or(hn::And(too_near(far), too_near(near)),
                                           hn::And(too_far(far), too_far(near))));
    }
    strikes.hits = hn::AndNot(rejected, strikes.hits);
    strikes.root = used;
    if constexpr (reach == Reach::Segment) // its point is not asked for
        return strikes;

    // With |T| + |2 a| below 2^34 each product below is at most 2^51, and so is their sum, twice.
    RealMask exact = fits(hn::Add(hn::Max(hn::Abs(far), hn::Abs(near)), whole), 34);
    const auto axis = [&](RealVec t, RealVec p0, RealVec p1) {
        const RealVec sum = hn::Add(hn::Mul(t, p1), hn::Mul(hn::Sub(whole, used), p0));
        return narrowed<rules>(quotient(sum, whole), exact);
    };
    strikes.point = {axis(rules == RuleSet::Rtl ? far : used, from.x, to.x),
                     axis(used, from.y, to.y), axis(used, from.z, to.z)};
    strikes.exact = hn::And(strikes.exact, hn::Or(exact, hn::Not(strikes.hits)));
    return strikes;
}

} // namespace raymarch::engine::sphere::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
