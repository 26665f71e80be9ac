// SPDX-License-Identifier: MIT
/// @file
/// multiplier.hpp and derivative.hpp in vectors.
#if defined(RAYMARCH_ENGINE_MANDELBULB_FAST_MULTIPLIER) == defined(HWY_TARGET_TOGGLE)
#ifdef RAYMARCH_ENGINE_MANDELBULB_FAST_MULTIPLIER
#undef RAYMARCH_ENGINE_MANDELBULB_FAST_MULTIPLIER
#else
#define RAYMARCH_ENGINE_MANDELBULB_FAST_MULTIPLIER
#endif

#include "engine/mandelbulb/derivative.hpp"
#include "engine/mandelbulb/fast/lanes-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace raymarch::engine::mandelbulb::fast::HWY_NAMESPACE
{

inline constexpr int unit_bits = Q57<Int128>::fraction_bits;

/// Ones from the leading one on down; a is below 2^width.
template <int width>
HWY_INLINE Vec<U64> filled(Vec<U64> a)
{
    if constexpr (width > 1) {
        constexpr int half = width / 2;
        a = filled<half>(a);
        return hn::Or(a, hn::ShiftRight<half>(a));
    } else {
        return a;
    }
}

/// How many bits it takes to write a: the index of the leading one, and one; 0 for 0.
template <int width = 64>
HWY_INLINE Vec<U64> bit_length(Vec<U64> a)
{
    return hn::PopulationCount(filled<width>(a));
}

/// Clears all but the `kept` bits from the leading one on: what lies above the lowest `kept` bits
/// is as long as what is cleared.
HWY_INLINE Vec<U64> keep(Vec<U64> a, int kept)
{
    if (kept >= all_bits)
        return a;
    const Vec<U64> above = hn::ShiftRightSame(a, kept);
    if (hn::AllTrue(U64(), hn::Eq(above, hn::Zero(U64()))))
        return a;
    const Vec<U64> cleared = kept >= 48   ? filled<16>(above)
                             : kept >= 32 ? filled<32>(above)
                                          : filled<64>(above);
    return hn::AndNot(cleared, a);
}

/// The factors are what keep() has left of them.
HWY_INLINE Vec<U64> kept_product(Vec<U64> a, Vec<U64> b)
{
    return shifted<unit_bits>(multiply(a, b));
}

/// These are Powers, but keep() has cut the lower one: the derivative takes no more of it.
struct PowersBatch
{
    Batch kept_lower;
    Batch upper;
};

HWY_INLINE PowersBatch powers(const Batch& r, int d, int kept)
{
    PowersBatch result;
    for (std::size_t j = 0; j < in_flight; ++j) {
        const Vec<U64> own = keep(r[j], kept);
        Vec<U64> square = own;
        int n = d - 1;
        for (; n % 2 == 0; n /= 2)
            square = keep(kept_product(square, square), kept);
        Vec<U64> lower = square;
        while ((n /= 2) != 0) {
            square = keep(kept_product(square, square), kept);
            if (n % 2 != 0)
                lower = keep(kept_product(lower, square), kept);
        }
        result.kept_lower[j] = lower;
        result.upper[j] = kept_product(lower, own);
    }
    return result;
}

/// fraction_bits is signed.
struct DerivativeBatch
{
    Batch mantissa;
    Batch fraction_bits;
};

/// d * r^(d-1) * dr + 1 takes 73 bits at most: r^(d-1) is below 32, and d at most 16.
HWY_INLINE DerivativeBatch next_derivative(const DerivativeBatch& dr, const Batch& kept_power,
                                           int d, int kept, DerivativeForm form)
{
    constexpr int overflow_bits = 16;
    const Vec<U64> one = Set<U64>(1);
    const Vec<U64> factor = Set<U64>(d);
    DerivativeBatch next;
    for (std::size_t j = 0; j < in_flight; ++j) {
        const Vec<U64> fraction = dr.fraction_bits[j];
        const DoubleWord whole = multiply(kept_power[j], keep(dr.mantissa[j], kept));
        const Vec<U64> product = shifted<unit_bits>(whole);
        const Vec<U64> first = multiply_halves(product, factor);
        const Vec<U64> second = hn::Add(multiply_halves(hn::ShiftRight<32>(product), factor),
                                        hn::ShiftRight<32>(first));
        const Vec<U64> low =
            hn::Or(hn::ShiftLeft<32>(second), hn::And(first, Set<U64>(0xFFFF'FFFF)));
        const Vec<U64> added =
            hn::AndNot(sign_of(fraction), hn::Shl(one, hn::And(fraction, Set<U64>(63))));
        const Vec<U64> sum = hn::Add(low, added);
        const Vec<U64> carry = hn::And(hn::VecFromMask(U64(), hn::Lt(sum, added)), one);
        const Vec<U64> overflow =
            hn::Add(multiply_halves(hn::ShiftRight<unit_bits>(whole.high), factor),
                    hn::Add(hn::ShiftRight<32>(second), carry));
        if (form == DerivativeForm::Saturating) {
            const Vec<U64> fits = hn::VecFromMask(U64(), hn::Eq(overflow, hn::Zero(U64())));
            next.mantissa[j] = hn::Or(hn::Not(fits), sum);
            next.fraction_bits[j] = fraction;
        } else {
            const Vec<U64> slide = bit_length<overflow_bits>(overflow);
            const Vec<U64> upper =
                hn::ShiftLeft<1>(hn::Shl(overflow, hn::Sub(Set<U64>(63), slide))); // 64 is no shift
            next.mantissa[j] = hn::Or(upper, hn::Shr(sum, slide));
            next.fraction_bits[j] = hn::Sub(fraction, slide);
        }
    }
    return next;
}

} // namespace raymarch::engine::mandelbulb::fast::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
