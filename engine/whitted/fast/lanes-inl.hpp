// SPDX-License-Identifier: MIT
/// @file
/// Words in the lanes of a vector, and the exact arithmetic on them: arithmetic.cpp for many rays
/// at once. Compiled once for each instruction set.
///
/// A lane has 32 bits. Whatever is wider is a pair: its low 32 bits, exact, and an estimate in
/// floating point. The estimate alone never decides: it says which of the numbers with these low
/// bits is meant, so that it may be wrong by far more than rounding makes it, and so that the
/// result is the same whether a machine fuses multiplications or not. docs/engine/whitted.md has
/// the proofs.
#include "engine/whitted/fast/packing_order.hpp"
#include "engine/whitted/fast/scene.hpp"

#include <hwy/highway.h>

// Opened once for each set, as Highway's own headers are.
#if defined(RAYMARCH_WHITTED_LANES) == defined(HWY_TARGET_TOGGLE) // NOLINT
#ifdef RAYMARCH_WHITTED_LANES
#undef RAYMARCH_WHITTED_LANES
#else
#define RAYMARCH_WHITTED_LANES
#endif

HWY_BEFORE_NAMESPACE();
namespace raymarch::engine::whitted::fast::HWY_NAMESPACE
{

namespace hn = hwy::HWY_NAMESPACE;

using Words = hn::ScalableTag<std::int32_t>;
using Reals = hn::ScalableTag<float>;
using Ints = hn::Vec<Words>;
using Floats = hn::Vec<Reals>;
using Lanes = hn::Mask<Words>; ///< some of them
inline constexpr Words words{};
inline constexpr Reals reals{};
inline constexpr std::size_t lane_count = hn::MaxLanes(Words());

/// Three words a lane.
struct Triple
{
    Ints x, y, z;
};

/// The same as floating point.
struct Real3
{
    Floats x, y, z;
};

HWY_INLINE Ints all(std::int32_t value)
{
    return hn::Set(words, value);
}
HWY_INLINE Ints all(std::uint32_t value)
{
    return all(static_cast<std::int32_t>(value));
}
HWY_INLINE Floats all(float value)
{
    return hn::Set(reals, value);
}

/// Of words and sums of two: exact.
HWY_INLINE Floats real(Ints a)
{
    return hn::ConvertTo(reals, a);
}
HWY_INLINE Real3 real(const Triple& v)
{
    return {real(v.x), real(v.y), real(v.z)};
}

HWY_INLINE Lanes lanes_of(hn::Mask<Reals> mask)
{
    return hn::RebindMask(words, mask);
}
HWY_INLINE bool none(Lanes lanes)
{
    return hn::AllFalse(words, lanes);
}
HWY_INLINE bool every(Lanes lanes)
{
    return hn::AllTrue(words, lanes);
}
HWY_INLINE Lanes no_lanes()
{
    return hn::MaskFromVec(hn::Zero(words));
}
HWY_INLINE Lanes both(Lanes a, Lanes b)
{
    return hn::And(a, b);
}
HWY_INLINE Lanes either(Lanes a, Lanes b)
{
    return hn::Or(a, b);
}
HWY_INLINE Lanes without(Lanes a, Lanes b)
{
    return hn::AndNot(b, a);
}
HWY_INLINE Lanes negative(Ints a)
{
    return hn::Lt(a, hn::Zero(words));
}
HWY_INLINE Lanes positive(Ints a)
{
    return hn::Gt(a, hn::Zero(words));
}
HWY_INLINE Ints choose(Lanes where, Ints there, Ints elsewhere)
{
    return hn::IfThenElse(where, there, elsewhere);
}
HWY_INLINE Lanes choose_lanes(Lanes where, Lanes there, Lanes elsewhere)
{
    return either(both(where, there), without(elsewhere, where));
}
HWY_INLINE Triple choose(Lanes where, const Triple& there, const Triple& elsewhere)
{
    return {choose(where, there.x, elsewhere.x), choose(where, there.y, elsewhere.y),
            choose(where, there.z, elsewhere.z)};
}

HWY_INLINE Ints any_bit(const Triple& v)
{
    return hn::Or(hn::Or(v.x, v.y), v.z);
}

HWY_INLINE Triple operator-(const Triple& a, const Triple& b)
{
    return {hn::Sub(a.x, b.x), hn::Sub(a.y, b.y), hn::Sub(a.z, b.z)};
}

/// Modulo 2^32.
HWY_INLINE Ints dot(const Triple& a, const Triple& b)
{
    return hn::Add(hn::Add(hn::Mul(a.x, b.x), hn::Mul(a.y, b.y)), hn::Mul(a.z, b.z));
}

HWY_INLINE Floats dot(const Real3& a, const Real3& b, Floats start)
{
    return hn::MulAdd(a.x, b.x, hn::MulAdd(a.y, b.y, hn::MulAdd(a.z, b.z, start)));
}

/// The nearest integer, of what is below 2^31; of anything else some integer.
HWY_INLINE Ints nearest(Floats a)
{
#if HWY_TARGET == HWY_AVX3
    return Ints{_mm512_cvtps_epi32(a.raw)};
#elif HWY_TARGET == HWY_AVX2
    return Ints{_mm256_cvtps_epi32(a.raw)}; // Highway's also mends what is out of range
#else
    return hn::NearestInt(a);
#endif
}

/// The lower 24 bits as a word.
HWY_INLINE Ints wrapped(Ints a)
{
    return hn::ShiftRight<8>(hn::ShiftLeft<8>(a));
}

/// The largest of the absolute components.
HWY_INLINE Ints reach_of(const Triple& v)
{
    return hn::Max(hn::Max(hn::Abs(v.x), hn::Abs(v.y)), hn::Abs(v.z));
}

/// q(x), not wrapped to a word: floor(x / 4096) of an x with these low 32 bits whose 4096th lies
/// within 2^18 of the estimate and below 2^31.
HWY_INLINE Ints floor_4096th(Ints low, Floats estimate)
{
    const Ints near = nearest(estimate);
    const Ints rest = hn::Sub(low, hn::ShiftLeft<fraction_bits>(near));
    return hn::Add(near, hn::ShiftRight<fraction_bits>(rest));
}

/// One less where the rest that belongs to it is negative.
HWY_INLINE Ints floored(Ints nearest, Ints rest)
{
    return hn::Add(nearest, hn::ShiftRight<31>(rest));
}

/// floor(sqrt(4096 v)), v from 0 to 2^24 - 1.
HWY_INLINE Ints square_root(Ints v)
{
    const Ints root = nearest(hn::Mul(hn::Sqrt(real(v)), all(64.0F)));
    return floored(root, hn::Sub(hn::ShiftLeft<fraction_bits>(v), hn::Mul(root, root)));
}

/// floor(4096 n / d), below 2^17; `scale` is 4096 / d, d positive.
HWY_INLINE Ints divide(Ints n, Ints d, Floats scale)
{
    const Ints quotient = nearest(hn::Mul(real(n), scale));
    return floored(quotient, hn::Sub(hn::ShiftLeft<fraction_bits>(n), hn::Mul(quotient, d)));
}

/// v / length, which is at least bounds::least_length and v's own.
HWY_INLINE Triple divide(const Triple& v, Ints length)
{
    const Floats scale = hn::Div(all(4096.0F), real(length));
    return {divide(v.x, length, scale), divide(v.y, length, scale), divide(v.z, length, scale)};
}

/// div(n, -d) of any word n and a d from 1 to 2^13: rounded up, wrapped.
HWY_INLINE Ints divide_by_negated(Ints n, Ints d)
{
    // Two digits to the base of 4096: a quotient has up to 35 bits. A first digit that is off by a
    // few makes up for it in the second.
    const Floats inverse = hn::Div(all(1.0F), real(d));
    const Ints first = nearest(hn::Mul(real(n), inverse));
    const Ints rest = hn::Sub(n, hn::Mul(first, d));
    const Ints second = divide(rest, d, hn::Mul(inverse, all(4096.0F)));
    return wrapped(hn::Neg(hn::Add(hn::ShiftLeft<fraction_bits>(first), second)));
}

/// The squared length of a vector that is to be normalised.
struct SquaredLength
{
    Ints whole;      ///< floor(N / 4096)
    Lanes fits;      ///< it is below 2^24
    Lanes too_short; ///< for bounds::least_length, if it fits
};

HWY_INLINE SquaredLength squared_length(Ints low, Floats estimate)
{
    constexpr std::int32_t least =
        bounds::least_length * bounds::least_length / (1 << fraction_bits);
    const Ints whole = floor_4096th(low, estimate);
    return {.whole = whole,
            .fits = lanes_of(hn::Lt(estimate, all(static_cast<float>((1 << 24) - 64)))),
            .too_short = hn::Lt(whole, all(least))};
}

/// v * k per axis, not wrapped: |v| at most bounds::direction, k a word.
HWY_INLINE Triple scaled(const Triple& v, Ints k)
{
    const Ints high = hn::ShiftRight<fraction_bits>(k);
    const Ints low = hn::And(k, all((1 << fraction_bits) - 1));
    const auto axis = [&](Ints c) {
        return hn::Add(hn::Mul(c, high), hn::ShiftRight<fraction_bits>(hn::Mul(c, low)));
    };
    return {axis(v.x), axis(v.y), axis(v.z)};
}

/// Some lanes of any number of vectors, stored close together. What follows them in memory, up to a
/// vector, is overwritten.
class Packing
{
  public:
#if HWY_TARGET == HWY_AVX2
    // One permutation for all vectors: Highway would find it again for each of them.
    HWY_INLINE explicit Packing(Lanes kept)
        : bits_(static_cast<unsigned>(_mm256_movemask_ps(_mm256_castsi256_ps(kept.raw))))
        , order_(_mm256_cvtepu8_epi32(_mm_loadl_epi64(
              reinterpret_cast<const __m128i*>(packing_order[bits_].data())))) // NOLINT
    {}
    [[nodiscard]] HWY_INLINE std::size_t count() const
    {
        return hwy::PopCount(bits_);
    }
    HWY_INLINE void store(Ints value, std::int32_t* to) const
    {
        hn::StoreU(Ints{_mm256_permutevar8x32_epi32(value.raw, order_)}, words, to);
    }

  private:
    unsigned bits_;
    __m256i order_;
#else
    HWY_INLINE explicit Packing(Lanes kept) : kept_(kept) {}
    [[nodiscard]] HWY_INLINE std::size_t count() const
    {
        return hn::CountTrue(words, kept_);
    }
    HWY_INLINE void store(Ints value, std::int32_t* to) const
    {
        hn::CompressStore(value, kept_, words, to);
    }

  private:
    Lanes kept_;
#endif
};

/// table[index], index below `rows`.
template <std::size_t rows>
HWY_INLINE Ints look_up(const Column& table, Ints index)
{
    if constexpr (rows <= lane_count) {
        return hn::TableLookupLanes(hn::Load(words, table.data()),
                                    hn::IndicesFromVec(words, index));
    } else if constexpr (rows == 2 * lane_count) {
        const auto lane = hn::IndicesFromVec(
            words, hn::And(index, all(static_cast<std::int32_t>(lane_count - 1))));
        return choose(hn::Gt(index, all(static_cast<std::int32_t>(lane_count - 1))),
                      hn::TableLookupLanes(hn::Load(words, table.data() + lane_count), lane),
                      hn::TableLookupLanes(hn::Load(words, table.data()), lane));
    } else {
        return hn::GatherIndex(words, table.data(), index);
    }
}
HWY_INLINE Ints of_sphere(const Column& table, Ints index)
{
    return look_up<table_rows>(table, index);
}
HWY_INLINE Ints of_plane(const Column& table, Ints index)
{
    return look_up<plane_count>(table, index);
}

} // namespace raymarch::engine::whitted::fast::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
