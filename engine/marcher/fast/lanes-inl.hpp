// SPDX-License-Identifier: MIT
/// @file
/// Vectors of 32-bit lanes and the 64-bit numbers between them.
#if defined(RAYMARCH_ENGINE_MARCHER_FAST_LANES) == defined(HWY_TARGET_TOGGLE)
#ifdef RAYMARCH_ENGINE_MARCHER_FAST_LANES
#undef RAYMARCH_ENGINE_MARCHER_FAST_LANES
#else
#define RAYMARCH_ENGINE_MARCHER_FAST_LANES
#endif

#include "engine/fast/vectors-inl.hpp"
#include "engine/marcher/formats.hpp"

HWY_BEFORE_NAMESPACE();
namespace raymarch::engine::marcher::fast::HWY_NAMESPACE
{

using namespace engine::fast::HWY_NAMESPACE;

/// One 64-bit number a lane, in two halves as the widening multiplication gives them.
struct Wide
{
    Vec<U64> even;
    Vec<U64> odd;
};

struct Points
{
    Vec<I32> x;
    Vec<I32> y;
    Vec<I32> z;
};

HWY_INLINE Points add(const Points& a, const Points& b)
{
    return {a.x + b.x, a.y + b.y, a.z + b.z};
}

HWY_INLINE Points subtract(const Points& a, const Points& b)
{
    return {a.x - b.x, a.y - b.y, a.z - b.z};
}

HWY_INLINE Points points(const Point& p)
{
    return {Set<I32>(p.x.raw()), Set<I32>(p.y.raw()), Set<I32>(p.z.raw())};
}

/// The odd lanes where the even ones were; multiplications look only there.
template <class V>
HWY_INLINE V odd_lanes(V v)
{
    return hn::BitCast(hn::DFromV<V>(), hn::ShiftRight<32>(hn::BitCast(U64(), v)));
}

HWY_INLINE Vec<U64> multiply_even(Vec<I32> a, Vec<I32> b)
{
    return hn::BitCast(U64(), hn::MulEven(a, b));
}

HWY_INLINE Vec<U64> multiply_even(Vec<U32> a, Vec<U32> b)
{
    return hn::MulEven(a, b);
}

/// The exact products.
template <class V>
HWY_INLINE Wide multiply(V a, V b)
{
    return {multiply_even(a, b), multiply_even(odd_lanes(a), odd_lanes(b))};
}

HWY_INLINE Wide add(const Wide& a, const Wide& b)
{
    return {a.even + b.even, a.odd + b.odd};
}

/// Shifts right by a number for each lane; the upper 32 bits of the result must not matter.
HWY_INLINE Wide shift_right(const Wide& v, Vec<U32> by)
{
    const Vec<U64> counts = hn::BitCast(U64(), by);
    const Vec<U64> low = hn::And(counts, Set<U64>(0xFFFF'FFFFU));
    return {v.even >> low, v.odd >> hn::ShiftRight<32>(counts)};
}

/// The lower 32 bits of each.
HWY_INLINE Vec<U32> lower(const Wide& v)
{
    return hn::OddEven(hn::BitCast(U32(), hn::ShiftLeft<32>(v.odd)), hn::BitCast(U32(), v.even));
}

/// The upper 32 bits of each.
HWY_INLINE Vec<U32> upper(const Wide& v)
{
    return hn::OddEven(hn::BitCast(U32(), v.odd), hn::BitCast(U32(), hn::ShiftRight<32>(v.even)));
}

} // namespace raymarch::engine::marcher::fast::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
