// SPDX-License-Identifier: MIT
/// @file
/// The unit of ray_sphere_unit.hpp in vectors of double, which hold integers of 53 bits: as long as
/// no number of a line is larger every step here is exact, and the lines beyond that are said to be
/// inexact, for the reference to compute.
#if defined(RAYMARCH_ENGINE_SPHERE_FAST_RAY_SPHERE_UNIT) == defined(HWY_TARGET_TOGGLE)
#ifdef RAYMARCH_ENGINE_SPHERE_FAST_RAY_SPHERE_UNIT
#undef RAYMARCH_ENGINE_SPHERE_FAST_RAY_SPHERE_UNIT
#else
#define RAYMARCH_ENGINE_SPHERE_FAST_RAY_SPHERE_UNIT
#endif

#include "engine/fast/vectors-inl.hpp"
#include "engine/sphere/ray_sphere_unit.hpp"

#include <cstdint>

HWY_BEFORE_NAMESPACE();
namespace raymarch::engine::sphere::fast::HWY_NAMESPACE
{

using namespace engine::fast::HWY_NAMESPACE;

/// Not Vec3, whose members would be compiled without the vectors' instructions.
struct Points
{
    Vec<F64> x;
    Vec<F64> y;
    Vec<F64> z;
};

HWY_INLINE Points points(const Point& p)
{
    return {Set<F64>(p.x), Set<F64>(p.y), Set<F64>(p.z)};
}

HWY_INLINE Points difference(const Points& a, const Points& b)
{
    return {hn::Sub(a.x, b.x), hn::Sub(a.y, b.y), hn::Sub(a.z, b.z)};
}

HWY_INLINE Vec<F64> dot(const Points& a, const Points& b)
{
    return hn::Add(hn::Mul(a.x, b.x), hn::Add(hn::Mul(a.y, b.y), hn::Mul(a.z, b.z)));
}

/// Says where |v| <= 2^bits, which is false for what is no number.
HWY_INLINE Mask<F64> fits(Vec<F64> v, int bits)
{
    return hn::Le(hn::Abs(v), Set<F64>(std::int64_t{1} << bits));
}

/// Names the sets of Rules, so that the compiler knows them.
enum class RuleSet : std::uint8_t { Rtl, Repaired, Prototype, Corrected };

/// Lines meet a sphere at these points. A line without a bit in `hits` has none.
struct Strikes
{
    Mask<F64> misses; ///< those that neither miss nor hit are rejected
    Mask<F64> hits;
    Mask<F64> exact;  ///< the rest holds here
    Vec<F64> squared; ///< the squared length of the line
    Vec<F64> root;
    Points point;
};

/// Of integers, towards zero. Exact for |a| <= 2^52 and |a| + |b| < 2^53: a quotient that is not an
/// integer is farther from the next one, by more than 2^-53 of it, than it is rounded.
HWY_INLINE Vec<F64> quotient(Vec<F64> a, Vec<F64> b)
{
    return hn::Trunc(hn::Div(a, b));
}

/// A coordinate as it leaves the unit; `exact` loses those for which that takes more than a double.
template <RuleSet rules>
HWY_INLINE Vec<F64> narrowed(Vec<F64> v, Mask<F64>& exact)
{
    constexpr std::int64_t limit = 1 << 17;
    if constexpr (rules == RuleSet::Corrected)
        return hn::Min(hn::Max(v, Set<F64>(-limit)), Set<F64>(limit - 1));
    if constexpr (rules == RuleSet::Prototype) {
        exact = hn::And(exact, fits(v, 17)); // and the low 32 bits are all
        return v;
    }
    const Vec<F64> word = Set<F64>(1 << 16);
    return hn::Sub(v, hn::Mul(word, hn::Floor(hn::Mul(v, Set<F64>(0x1p-16)))));
}

/// The points where lines meet the sphere; `near` and `far` are the roots, times `whole`.
template <RuleSet rules>
HWY_INLINE void set_points(Strikes& strikes, const Points& from, const Points& to, Vec<F64> near,
                           Vec<F64> far, Vec<F64> whole)
{
    // With |T| + |2 a| below 2^34 each product below is at most 2^51, and so is their sum, twice.
    Mask<F64> exact = fits(hn::Add(hn::Max(hn::Abs(far), hn::Abs(near)), whole), 34);
    const Vec<F64> used = strikes.root;
    const auto axis = [&](Vec<F64> t, Vec<F64> p0, Vec<F64> p1) {
        const Vec<F64> sum = hn::Add(hn::Mul(t, p1), hn::Mul(hn::Sub(whole, used), p0));
        return narrowed<rules>(quotient(sum, whole), exact);
    };
    strikes.point = {axis(rules == RuleSet::Rtl ? far : used, from.x, to.x),
                     axis(used, from.y, to.y), axis(used, from.z, to.z)};
    strikes.exact = hn::And(strikes.exact, hn::Or(exact, hn::Not(strikes.hits)));
}

/// intersect(), of coordinates up to 2^17. `beside` is from - centre, and `c` its squared length
/// less the squared radius.
template <RuleSet rules, Reach reach>
HWY_INLINE Strikes intersect(const Points& from, const Points& to, const Points& beside, Vec<F64> c,
                             std::int32_t derounder)
{
    constexpr bool hardware = rules == RuleSet::Rtl || rules == RuleSet::Repaired;
    Strikes strikes;
    // Differences are below 2^18.6, so these are below 2^40.
    const Points along = difference(to, from);
    const Vec<F64> a = dot(along, along);
    const Vec<F64> half_b = dot(along, beside);

    // A quarter of the discriminant: exact where both products are, which then are below 2^51.
    const Vec<F64> first = hn::Mul(half_b, half_b);
    const Vec<F64> second = hn::Mul(a, c);
    const Vec<F64> discriminant = hn::Sub(first, second);
    strikes.exact = hn::And(fits(first, 49), fits(second, 49));
    if constexpr (rules == RuleSet::Prototype) // coefficients of 32 bits are not cut
        strikes.exact =
            hn::And(strikes.exact, hn::And(fits(a, 30), hn::And(fits(half_b, 29), fits(c, 30))));
    strikes.misses =
        hardware ? hn::Le(discriminant, Set<F64>(0)) : hn::Lt(discriminant, Set<F64>(0));
    strikes.squared = a;
    strikes.hits = hn::Not(strikes.misses);
    if (hn::AllFalse(F64(), strikes.hits))
        return strikes;

    // Below 2^52 the root of a double has the same floor as the root itself, in both designs.
    const Vec<F64> root = hn::Floor(hn::Sqrt(hn::Mul(discriminant, Set<F64>(4))));
    const Vec<F64> shift = derounder == 0 ? Set<F64>(0) : quotient(a, Set<F64>(derounder));
    const Vec<F64> middle = hn::Sub(hn::Mul(half_b, Set<F64>(-2)), shift);
    const Vec<F64> far = hn::Add(middle, root);
    const Vec<F64> near = hn::Sub(middle, root);
    const Vec<F64> whole = hn::Add(a, a);
    const Vec<F64> threshold = Set<F64>(reach == Reach::Segment ? segment_threshold : 0);

    const auto too_near = [&](Vec<F64> t) {
        // Without a sign a negative T is a huge one.
        return rules == RuleSet::Rtl ? hn::And(hn::Ge(t, Set<F64>(0)), hn::Lt(t, threshold))
                                     : hn::Lt(t, threshold);
    };
    const auto too_far = [&](Vec<F64> t) {
        return reach == Reach::Segment ? hn::Gt(t, whole) : hn::MaskFromVec(Set<F64>(0));
    };
    Vec<F64> used = near;
    Mask<F64> rejected = hn::Eq(a, Set<F64>(0));
    if constexpr (rules == RuleSet::Corrected) {
        const Mask<F64> near_out = hn::Or(too_near(near), too_far(near));
        const Mask<F64> far_out = hn::Or(too_near(far), too_far(far));
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

    set_points<rules>(strikes, from, to, near, far, whole);
    return strikes;
}

} // namespace raymarch::engine::sphere::fast::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
