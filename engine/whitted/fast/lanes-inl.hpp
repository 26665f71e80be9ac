// SPDX-License-Identifier: MIT
/// @file
/// Words in the lanes of a vector, and the exact arithmetic on them: arithmetic.cpp for many rays
/// at once.
///
/// A lane has 32 bits. Whatever is wider is a pair: its low 32 bits, exact, and an estimate in
/// floating point. The estimate alone never decides: it says which of the numbers with these low
/// bits is meant, so that it may be wrong by far more than rounding makes it, and so that the
/// result is the same whether a machine fuses multiplications or not. docs/engine/whitted.md has
/// the proofs.
#if defined(RAYMARCH_ENGINE_WHITTED_FAST_LANES) == defined(HWY_TARGET_TOGGLE)
#ifdef RAYMARCH_ENGINE_WHITTED_FAST_LANES
#undef RAYMARCH_ENGINE_WHITTED_FAST_LANES
#else
#define RAYMARCH_ENGINE_WHITTED_FAST_LANES
#endif

#include "engine/fast/vectors-inl.hpp"
#include "engine/whitted/fast/scene.hpp"

HWY_BEFORE_NAMESPACE();
namespace raymarch::engine::whitted::fast::HWY_NAMESPACE
{

using namespace engine::fast::HWY_NAMESPACE;

/// Three words a lane.
struct Triple
{
    Vec<I32> x, y, z;
};

/// Three estimates a lane.
struct Real3
{
    Vec<F32> x, y, z;
};

/// The conversion of words and of sums of two is exact.
HWY_INLINE Vec<F32> real(Vec<I32> a)
{
    return hn::ConvertTo(F32(), a);
}
HWY_INLINE Real3 real(const Triple& v)
{
    return {real(v.x), real(v.y), real(v.z)};
}

HWY_INLINE Mask<I32> no_lanes()
{
    return hn::MaskFromVec(hn::Zero(I32()));
}
HWY_INLINE Mask<I32> negative(Vec<I32> a)
{
    return hn::Lt(a, hn::Zero(I32()));
}
HWY_INLINE Mask<I32> positive(Vec<I32> a)
{
    return hn::Gt(a, hn::Zero(I32()));
}
HWY_INLINE Mask<I32> choose_lanes(Mask<I32> where, Mask<I32> there, Mask<I32> elsewhere)
{
    return hn::Or(hn::And(where, there), hn::AndNot(where, elsewhere));
}
HWY_INLINE Triple IfThenElse(Mask<I32> where, const Triple& there, const Triple& elsewhere)
{
    return {IfThenElse(where, there.x, elsewhere.x), IfThenElse(where, there.y, elsewhere.y),
            IfThenElse(where, there.z, elsewhere.z)};
}

HWY_INLINE Vec<I32> any_bit(const Triple& v)
{
    return hn::Or(hn::Or(v.x, v.y), v.z);
}

HWY_INLINE Triple operator-(const Triple& a, const Triple& b)
{
    return {hn::Sub(a.x, b.x), hn::Sub(a.y, b.y), hn::Sub(a.z, b.z)};
}

/// Modulo 2^32.
HWY_INLINE Vec<I32> dot(const Triple& a, const Triple& b)
{
    return hn::Add(hn::Add(hn::Mul(a.x, b.x), hn::Mul(a.y, b.y)), hn::Mul(a.z, b.z));
}

HWY_INLINE Vec<F32> dot(const Real3& a, const Real3& b, Vec<F32> start)
{
    return hn::MulAdd(a.x, b.x, hn::MulAdd(a.y, b.y, hn::MulAdd(a.z, b.z, start)));
}

/// The nearest integer, of what is below 2^31; of anything else some integer.
HWY_INLINE Vec<I32> nearest(Vec<F32> a)
{
#if HWY_TARGET == HWY_AVX3
    return Vec<I32>{_mm512_cvtps_epi32(a.raw)};
#elif HWY_TARGET == HWY_AVX2
    return Vec<I32>{_mm256_cvtps_epi32(a.raw)}; // Highway's also mends what is out of range
#else
    return hn::NearestInt(a);
#endif
}

/// The lower 24 bits as a word.
HWY_INLINE Vec<I32> wrapped(Vec<I32> a)
{
    return hn::ShiftRight<8>(hn::ShiftLeft<8>(a));
}

/// The largest of the absolute components.
HWY_INLINE Vec<I32> reach_of(const Triple& v)
{
    return hn::Max(hn::Max(hn::Abs(v.x), hn::Abs(v.y)), hn::Abs(v.z));
}

/// q(x), not wrapped to a word: floor(x / 4096) of an x with these low 32 bits whose 4096th lies
/// within 2^18 of the estimate and below 2^31.
HWY_INLINE Vec<I32> floor_4096th(Vec<I32> low, Vec<F32> estimate)
{
    const Vec<I32> near = nearest(estimate);
    const Vec<I32> rest = hn::Sub(low, hn::ShiftLeft<fraction_bits>(near));
    return hn::Add(near, hn::ShiftRight<fraction_bits>(rest));
}

/// One less where the rest that belongs to it is negative.
HWY_INLINE Vec<I32> floored(Vec<I32> nearest, Vec<I32> rest)
{
    return hn::Add(nearest, hn::ShiftRight<31>(rest));
}

/// floor(sqrt(4096 v)), v from 0 to 2^24 - 1.
HWY_INLINE Vec<I32> square_root(Vec<I32> v)
{
    const Vec<I32> root = nearest(hn::Mul(hn::Sqrt(real(v)), Set<F32>(64.0F)));
    return floored(root, hn::Sub(hn::ShiftLeft<fraction_bits>(v), hn::Mul(root, root)));
}

/// floor(4096 n / d), below 2^17; `scale` is 4096 / d, d positive.
HWY_INLINE Vec<I32> divide(Vec<I32> n, Vec<I32> d, Vec<F32> scale)
{
    const Vec<I32> quotient = nearest(hn::Mul(real(n), scale));
    return floored(quotient, hn::Sub(hn::ShiftLeft<fraction_bits>(n), hn::Mul(quotient, d)));
}

/// v / length, which is at least bounds::least_length and v's own.
HWY_INLINE Triple divide(const Triple& v, Vec<I32> length)
{
    const Vec<F32> scale = hn::Div(Set<F32>(4096.0F), real(length));
    return {divide(v.x, length, scale), divide(v.y, length, scale), divide(v.z, length, scale)};
}

/// div(n, -d) of any word n and a d from 1 to 2^13: rounded up, wrapped.
HWY_INLINE Vec<I32> divide_by_negated(Vec<I32> n, Vec<I32> d)
{
    // Two digits to the base of 4096: a quotient has up to 35 bits. A first digit that is off by a
    // few makes up for it in the second.
    const Vec<F32> inverse = hn::Div(Set<F32>(1.0F), real(d));
    const Vec<I32> first = nearest(hn::Mul(real(n), inverse));
    const Vec<I32> rest = hn::Sub(n, hn::Mul(first, d));
    const Vec<I32> second = divide(rest, d, hn::Mul(inverse, Set<F32>(4096.0F)));
    return wrapped(hn::Neg(hn::Add(hn::ShiftLeft<fraction_bits>(first), second)));
}

/// The squared length of a vector that is to be normalised.
struct SquaredLength
{
    Vec<I32> whole;      ///< floor(N / 4096)
    Mask<I32> fits;      ///< it is below 2^24
    Mask<I32> too_short; ///< for bounds::least_length, if it fits
};

HWY_INLINE SquaredLength squared_length(Vec<I32> low, Vec<F32> estimate)
{
    constexpr std::int32_t least =
        bounds::least_length * bounds::least_length / (1 << fraction_bits);
    const Vec<I32> whole = floor_4096th(low, estimate);
    return {.whole = whole,
            .fits = hn::RebindMask(I32(),
                                   hn::Lt(estimate, Set<F32>(static_cast<float>((1 << 24) - 64)))),
            .too_short = hn::Lt(whole, Set<I32>(least))};
}

/// v * k per axis, not wrapped: |v| at most bounds::direction, k a word.
HWY_INLINE Triple scaled(const Triple& v, Vec<I32> k)
{
    const Vec<I32> high = hn::ShiftRight<fraction_bits>(k);
    const Vec<I32> low = hn::And(k, Set<I32>((1 << fraction_bits) - 1));
    const auto axis = [&](Vec<I32> c) {
        return hn::Add(hn::Mul(c, high), hn::ShiftRight<fraction_bits>(hn::Mul(c, low)));
    };
    return {axis(v.x), axis(v.y), axis(v.z)};
}

/// table[index], index below `rows`.
template <std::size_t rows>
HWY_INLINE Vec<I32> look_up(const Column& table, Vec<I32> index)
{
    if constexpr (rows <= lanes<I32>) {
        return hn::TableLookupLanes(hn::Load(I32(), table.data()),
                                    hn::IndicesFromVec(I32(), index));
    } else if constexpr (rows == 2 * lanes<I32>) {
        const auto lane = hn::IndicesFromVec(I32(), hn::And(index, Set<I32>(lanes<I32> - 1)));
        return IfThenElse(hn::Gt(index, Set<I32>(lanes<I32> - 1)),
                          hn::TableLookupLanes(hn::Load(I32(), table.data() + lanes<I32>), lane),
                          hn::TableLookupLanes(hn::Load(I32(), table.data()), lane));
    } else {
        return hn::GatherIndex(I32(), table.data(), index);
    }
}
HWY_INLINE Vec<I32> of_sphere(const Column& table, Vec<I32> index)
{
    return look_up<table_rows>(table, index);
}
HWY_INLINE Vec<I32> of_plane(const Column& table, Vec<I32> index)
{
    return look_up<plane_count>(table, index);
}

} // namespace raymarch::engine::whitted::fast::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
