// SPDX-License-Identifier: MIT
/// @file
/// The stage of inverse_sqrt.hpp in vectors.
#if defined(RAYMARCH_ENGINE_FRACTAL_FAST_INVERSE_SQRT) == defined(HWY_TARGET_TOGGLE)
#ifdef RAYMARCH_ENGINE_FRACTAL_FAST_INVERSE_SQRT
#undef RAYMARCH_ENGINE_FRACTAL_FAST_INVERSE_SQRT
#else
#define RAYMARCH_ENGINE_FRACTAL_FAST_INVERSE_SQRT
#endif

#include "engine/fractal/fast/lanes-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace raymarch::engine::fractal::fast::HWY_NAMESPACE
{

/// From here on inverse_sqrt() below is exact: a quarter.
inline constexpr std::int32_t least_radicand = 1 << 14;

/// inverse_sqrt(a) of words from `least_radicand` to 2^22 - 1, which are the negative ones too.
///
/// The reference multiplies words of 22 bits; here each product is split so that it fits a lane.
/// With root = 1 + r and the factor of a round = 1 + u, in 65536ths, a product of both is exactly
/// 1 + r + u + floor(r * u), and square likewise. That no lane overflows holds for the roots of
/// mantissas from a quarter to 1, and is tested for each of these.
HWY_INLINE Vec<I32> inverse_sqrt(Vec<I32> a)
{
    const U32 bits;
    const hn::RebindToFloat<I32> exact; // numbers of 24 bits hold all words
    // k + 126 + 16 is the exponent of a word from 1 on; below, k is 0.
    const Vec<I32> exponent =
        hn::BitCast(I32(), hn::ShiftRight<23>(hn::BitCast(bits, hn::ConvertTo(exact, a))));
    const Vec<I32> k = hn::Max(hn::Sub(exponent, Set<I32>(126 + 16)), hn::Zero(I32()));
    const Vec<I32> mantissa = a >> k;

    constexpr std::int32_t unit = one.raw();
    const auto floor16 = [](Vec<I32> v) { return hn::ShiftRight<16>(v); };
    const auto bits16 = [&](Vec<I32> v) { // of products up to 2^32
        return hn::BitCast(I32(), hn::ShiftRight<16>(hn::BitCast(bits, v)));
    };
    Vec<I32> r =
        hn::Sub(Set<I32>(92681 - unit),
                floor16(hn::Mul(Set<I32>(54291), hn::Sub(mantissa, Set<I32>(half.raw())))));
    const Vec<I32> halved = hn::ShiftRight<1>(mantissa);
    for (int round = 0; round < 2; ++round) {
        const Vec<I32> square =
            hn::Add(hn::Add(Set<I32>(unit), hn::Add(r, r)), bits16(hn::Mul(r, r)));
        const Vec<I32> u =
            hn::Sub(Set<I32>(three_halves.raw() - unit), bits16(hn::Mul(halved, square)));
        r = hn::Add(hn::Add(r, u), floor16(hn::Mul(r, u)));
    }
    const Vec<I32> root = hn::Add(r, Set<I32>(unit)) >> hn::ShiftRight<1>(k);
    const auto odd = hn::TestBit(k, Set<I32>(1));
    return hn::IfThenElse(odd, bits16(hn::Mul(root, Set<I32>(46340))), root);
}

} // namespace raymarch::engine::fractal::fast::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
