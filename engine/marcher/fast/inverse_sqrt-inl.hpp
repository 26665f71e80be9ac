// SPDX-License-Identifier: MIT
/// @file
/// The inverse square root stage on vectors (docs/engine.md, 2 and "Fast kernels").
#if defined(RAYMARCH_ENGINE_MARCHER_FAST_INVERSE_SQRT) == defined(HWY_TARGET_TOGGLE)
#ifdef RAYMARCH_ENGINE_MARCHER_FAST_INVERSE_SQRT
#undef RAYMARCH_ENGINE_MARCHER_FAST_INVERSE_SQRT
#else
#define RAYMARCH_ENGINE_MARCHER_FAST_INVERSE_SQRT
#endif

#include "engine/marcher/fast/lanes-inl.hpp"
#include "engine/marcher/inverse_sqrt_table.hpp"

#include <type_traits>

HWY_BEFORE_NAMESPACE();
namespace raymarch::engine::marcher::fast::HWY_NAMESPACE
{

/// S = n * 2^-z with the top bit of n set. A zero gives an exponent that shifts everything out.
struct Normalised
{
    Vec<U32> upper;    ///< of n, 32 bits; its top bit may be missing
    Vec<U32> exponent; ///< e = 63 - z, plus a bias that is odd
};

/// How large the squares can be.
enum class Squares : bool {
    Any,   ///< below 2^64
    Small, ///< below 2^52: vectors shorter than 4 units
};

#if HWY_HAVE_FLOAT64

constexpr std::uint32_t exponent_bias = 1023;

/// The number as a double, whose exponent is e and whose mantissa begins with the upper 32 bits of
/// n.
template <Squares squares>
HWY_INLINE Vec<U64> bits_of_double(Vec<U64> s)
{
    const hn::Repartition<double, U64> doubles;
#if HWY_TARGET == HWY_AVX3 // has it as an instruction, which cuts off
    return hn::BitCast(U64(), hn::Vec<decltype(doubles)>{_mm512_cvt_roundepu64_pd(
                                  s.raw, _MM_FROUND_TO_ZERO | _MM_FROUND_NO_EXC)});
#else
    const Vec<U64> low_magic = Set<U64>(0x4330'0000'0000'0000); // 2^52
    if constexpr (squares == Squares::Small)
        return hn::BitCast(
            U64(), hn::Sub(hn::BitCast(doubles, hn::Or(s, low_magic)), hn::Set(doubles, 0x1p52)));
    // The upper half times 2^32 and the lower half, each exact behind a power of two; their sum is
    // rounded. To keep a carry from running into the upper 32 bits of n, a zero is put in its way:
    // bit e - 40 is cleared, with some of those below it.
    const Vec<U64> safe = hn::AndNot(hn::ShiftRight<40>(s), s);
    const Vec<U64> high = hn::Or(hn::ShiftRight<32>(safe), Set<U64>(0x4530'0000'0000'0000));
    const auto low = hn::OddEven(hn::BitCast(U32(), low_magic), hn::BitCast(U32(), safe));
    const auto upper = hn::Sub(hn::BitCast(doubles, high), hn::Set(doubles, 0x1.00000001p84));
    return hn::BitCast(U64(), hn::Add(upper, hn::BitCast(doubles, low)));
#endif
}

template <Squares squares>
HWY_INLINE Normalised normalised(const Wide& s)
{
    const Wide bits{bits_of_double<squares>(s.even), bits_of_double<squares>(s.odd)};
    return {lower({hn::ShiftRight<21>(bits.even), hn::ShiftRight<21>(bits.odd)}),
            hn::ShiftRight<20>(upper(bits))};
}

#else // the board's vectors have no doubles, but count leading zeros

constexpr std::uint32_t exponent_bias = 1;

HWY_INLINE Vec<U32> leading_zeros(Vec<U32> v)
{
    return Vec<U32>(vclzq_u32(v.raw));
}

template <Squares /*squares*/>
HWY_INLINE Normalised normalised(const Wide& s)
{
    const Vec<U32> high = upper(s);
    const Vec<U32> low = lower(s);
    const Vec<U32> of_high = leading_zeros(high);
    const Vec<U32> of_low = leading_zeros(low);
    const Vec<U32> zeros =
        hn::IfThenElse(hn::Eq(of_high, Set<U32>(32)), of_low + Set<U32>(32), of_high);
    // From 32 on, a shift takes what it needs from the lower half alone.
    const Vec<U32> left = high << hn::Min(zeros, Set<U32>(31));
    const Vec<U32> in_low = low << hn::And(zeros, Set<U32>(31));
    const Vec<U32> from_low =
        low >> (Set<U32>(32) - hn::Min(hn::Max(zeros, Set<U32>(1)), Set<U32>(31)));
    const auto far = hn::Gt(zeros, Set<U32>(31));
    const auto none = hn::Eq(zeros, hn::Zero(U32()));
    return {hn::IfThenElse(far, in_low, hn::Or(left, hn::IfThenZeroElse(none, from_low))),
            Set<U32>(63 + exponent_bias) - zeros};
}

#endif

/// T[i] below, T[i] - T[i+1] above.
HWY_INLINE Wide falling_entries(Vec<U32> index)
{
#if HWY_TARGET == HWY_AVX2
    // On Zen 3 three quarters of the time that two gathers take.
    const auto pair = [&](auto place) HWY_ATTR {
        constexpr int at = decltype(place)::value; // an immediate without optimisation, too
        return static_cast<std::uint64_t>(_mm256_extract_epi64(index.raw, at));
    };
    const std::uint64_t at01 = pair(std::integral_constant<int, 0>());
    const std::uint64_t at23 = pair(std::integral_constant<int, 1>());
    const std::uint64_t at45 = pair(std::integral_constant<int, 2>());
    const std::uint64_t at67 = pair(std::integral_constant<int, 3>());
    const auto even = [&](std::uint64_t low, std::uint64_t high) HWY_ATTR {
        return _mm_set_epi64x(
            static_cast<std::int64_t>(inverse_sqrt_table::falls[high & 0xFFFF'FFFF]),
            static_cast<std::int64_t>(inverse_sqrt_table::falls[low & 0xFFFF'FFFF]));
    };
    const auto odd = [&](std::uint64_t low, std::uint64_t high) HWY_ATTR {
        return _mm_set_epi64x(static_cast<std::int64_t>(inverse_sqrt_table::falls[high >> 32]),
                              static_cast<std::int64_t>(inverse_sqrt_table::falls[low >> 32]));
    };
    return {Vec<U64>{_mm256_set_m128i(even(at45, at67), even(at01, at23))},
            Vec<U64>{_mm256_set_m128i(odd(at45, at67), odd(at01, at23))}};
#else
    const hn::RebindToSigned<U64> places;
    const Vec<U64> at = hn::BitCast(U64(), index);
    const auto entries_at = [&](Vec<U64> place) HWY_ATTR {
        return hn::GatherIndex(U64(), inverse_sqrt_table::falls.data(), hn::BitCast(places, place));
    };
    return {entries_at(hn::And(at, Set<U64>(0xFFFF'FFFF))), entries_at(hn::ShiftRight<32>(at))};
#endif
}

/// Computes InverseSqrt without its shift, which each use finds in its own way.
HWY_INLINE Wide mantissa(const Normalised& n)
{
    using namespace inverse_sqrt_table;
    const Vec<U32> index = hn::And(hn::ShiftRight<31 - index_bits>(n.upper), Set<U32>(entries - 1));
    const Vec<U32> step = hn::And(hn::ShiftRight<31 - index_bits - step_bits>(n.upper),
                                  Set<U32>((1U << step_bits) - 1));
    const Wide entry = falling_entries(index);
    const Vec<U32> interpolated = lower(entry) - hn::ShiftRight<step_bits>(upper(entry) * step);
    // An even e wants * half_root >> 32; that constant is even, so * half_root/2 >> 31 is the
    // same, and * 2^31 >> 31 leaves the others as they are.
    static_assert(half_root % 2 == 0);
    const auto odd_exponent = hn::Eq(hn::And(n.exponent, Set<U32>(1)), hn::Zero(U32()));
    const Vec<U32> factor = hn::IfThenElse(odd_exponent, Set<U32>(1U << 31),
                                           Set<U32>(static_cast<std::uint32_t>(half_root / 2)));
    const Wide product = multiply(interpolated, factor);
    return {hn::ShiftRight<31>(product.even), hn::ShiftRight<31>(product.odd)};
}

HWY_INLINE Wide square(Vec<I32> v)
{
    return multiply(v, v);
}

/// The products of a lane's number and its mantissa.
template <class V>
HWY_INLINE Wide multiply(V v, const Wide& mantissa)
{
    const auto factor = [](Vec<U64> half) HWY_ATTR { return hn::BitCast(hn::DFromV<V>(), half); };
    return {multiply_even(v, factor(mantissa.even)),
            multiply_even(odd_lanes(v), factor(mantissa.odd))};
}

/// v / |v| of 32-bit integers; zero for zero.
template <Squares squares>
HWY_INLINE Points normalise(const Points& v)
{
    const Normalised n = normalised<squares>(add(add(square(v.x), square(v.y)), square(v.z)));
    const Wide m = mantissa(n); // below 2^31
    // s = 6 + ceil(e / 2), at most 38: when zeros come in from above, at least 26 bits of the
    // quotient are left. The component has 26 with its sign, and is extended again. Up to s = 32
    // its lower 32 bits are all right as they are.
    const Vec<U32> shift =
        hn::ShiftRight<1>(n.exponent) - Set<U32>((exponent_bias - 1) / 2) + Set<U32>(6);
    const auto component = [&](Vec<I32> c) HWY_ATTR {
        const Vec<I32> quotient = hn::BitCast(I32(), lower(shift_right(multiply(c, m), shift)));
        if constexpr (squares == Squares::Small)
            return quotient;
        else
            return hn::ShiftRight<6>(hn::ShiftLeft<6>(quotient));
    };
    return {component(v.x), component(v.y), component(v.z)};
}

/// The root of S as the model's length() takes it.
template <Squares squares>
HWY_INLINE Vec<I32> length(const Wide& squared)
{
    const Normalised n = normalised<squares>(squared);
    const Vec<U32> above = hn::Or(n.upper, Set<U32>(1U << 31));
    // s + z - 8 = 61 - floor(e / 2)
    const Vec<U32> shift =
        Set<U32>(61 + (exponent_bias + 1) / 2) - hn::ShiftRight<1>(n.exponent + Set<U32>(1));
    return hn::BitCast(I32(), lower(shift_right(multiply(above, mantissa(n)), shift)));
}

} // namespace raymarch::engine::marcher::fast::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
