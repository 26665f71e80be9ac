// SPDX-License-Identifier: MIT
/// @file
/// The stage of inverse_sqrt.hpp in vectors. Compiled once for each instruction set.
#if defined(RAYMARCH_ENGINE_FRACTAL_FAST_INVERSE_SQRT) == defined(HWY_TARGET_TOGGLE)
#ifdef RAYMARCH_ENGINE_FRACTAL_FAST_INVERSE_SQRT
#undef RAYMARCH_ENGINE_FRACTAL_FAST_INVERSE_SQRT
#else
#define RAYMARCH_ENGINE_FRACTAL_FAST_INVERSE_SQRT
#endif

#include "engine/fractal/fast/lanes-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace raymarch::engine::fractal::HWY_NAMESPACE
{

/// From here on inverse_sqrt() below is exact: a quarter.
inline constexpr std::int32_t least_radicand = 1 << 14;

/// inverse_sqrt(a) of words from `least_radicand` to 2^22 - 1, which are the negative ones too.
///
/// The reference multiplies words of 22 bits; here each product is split so that it fits a lane.
/// With root = 1 + r and the factor of a round = 1 + u, in 65536ths, a product of both is exactly
/// 1 + r + u + floor(r * u), and square likewise. That no lane overflows holds for the roots of
/// mantissas from a quarter to 1, and is tested for each of these.
HWY_INLINE WideVec inverse_sqrt(WideVec a)
{
    const WideBits bits;
    const hn::RebindToFloat<Wide> exact; // numbers of 24 bits hold all words
    // k + 126 + 16 is the exponent of a word from 1 on; below, k is 0.
    const WideVec exponent =
        hn::BitCast(Wide(), hn::ShiftRight<23>(hn::BitCast(bits, hn::ConvertTo(exact, a))));
    const WideVec k = hn::Max(hn::Sub(exponent, wide(126 + 16)), hn::Zero(Wide()));
    const WideVec mantissa = a >> k;

    constexpr std::int32_t unit = one.raw();
    const auto floor16 = [](WideVec v) { return hn::ShiftRight<16>(v); };
    const auto bits16 = [&](WideVec v) { // of products up to 2^32
        return hn::BitCast(Wide(), hn::ShiftRight<16>(hn::BitCast(bits, v)));
    };
    WideVec r = hn::Sub(wide(92681 - unit),
                        floor16(hn::Mul(wide(54291), hn::Sub(mantissa, wide(half.raw())))));
    const WideVec halved = hn::ShiftRight<1>(mantissa);
    for (int round = 0; round < 2; ++round) {
        const WideVec square = hn::Add(hn::Add(wide(unit), hn::Add(r, r)), bits16(hn::Mul(r, r)));
        const WideVec u = hn::Sub(wide(three_halves.raw() - unit), bits16(hn::Mul(halved, square)));
        r = hn::Add(hn::Add(r, u), floor16(hn::Mul(r, u)));
    }
    const WideVec root = hn::Add(r, wide(unit)) >> hn::ShiftRight<1>(k);
    const auto odd = hn::TestBit(k, wide(1));
    return hn::IfThenElse(odd, bits16(hn::Mul(root, wide(46340))), root);
}

} // namespace raymarch::engine::fractal::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
