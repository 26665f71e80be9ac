// SPDX-License-Identifier: MIT
/// @file
/// The vectors that the Mandelbulb's kernels compute in: 64-bit words, a coordinate of Q8.57 or an
/// angle a lane. Compiled once for each instruction set.
#if defined(RAYMARCH_ENGINE_MANDELBULB_FAST_LANES) == defined(HWY_TARGET_TOGGLE)
#ifdef RAYMARCH_ENGINE_MANDELBULB_FAST_LANES
#undef RAYMARCH_ENGINE_MANDELBULB_FAST_LANES
#else
#define RAYMARCH_ENGINE_MANDELBULB_FAST_LANES
#endif

#include <hwy/highway.h>

#include <array>
#include <cstddef>
#include <cstdint>

HWY_BEFORE_NAMESPACE();
namespace raymarch::engine::mandelbulb::HWY_NAMESPACE
{

namespace hn = hwy::HWY_NAMESPACE;

using Words = hn::ScalableTag<std::uint64_t>;
using SignedWords = hn::RebindToSigned<Words>;
using Vec = hn::Vec<Words>;
inline constexpr std::size_t lanes = HWY_LANES(std::uint64_t);

/// Vectors in flight: a step of CORDIC waits for the one before it.
inline constexpr std::size_t in_flight = 2;
inline constexpr std::size_t batch = in_flight * lanes; ///< lanes that are computed together
using Batch = std::array<Vec, in_flight>;

HWY_INLINE Vec all(std::uint64_t value)
{
    return hn::Set(Words(), value);
}

HWY_INLINE Batch load(const std::uint64_t* from)
{
    Batch values;
    for (std::size_t j = 0; j < in_flight; ++j)
        values[j] = hn::LoadU(Words(), from + j * lanes);
    return values;
}

HWY_INLINE void store(const Batch& values, std::uint64_t* to)
{
    for (std::size_t j = 0; j < in_flight; ++j)
        hn::StoreU(values[j], Words(), to + j * lanes);
}

/// All ones for a negative number, else 0, as sign_of() of the scalar stages.
HWY_INLINE Vec sign_of(Vec a)
{
    return hn::BitCast(Words(), hn::BroadcastSignBit(hn::BitCast(SignedWords(), a)));
}

/// a > b, as signed numbers: all ones or 0.
HWY_INLINE Vec greater(Vec a, Vec b)
{
    const SignedWords d;
    return hn::BitCast(Words(), hn::VecFromMask(d, hn::Gt(hn::BitCast(d, a), hn::BitCast(d, b))));
}

/// a == b: all ones or 0.
HWY_INLINE Vec equal(Vec a, Vec b)
{
    return hn::VecFromMask(Words(), hn::Eq(a, b));
}

/// yes where `mask` is all ones, else no.
HWY_INLINE Vec select(Vec mask, Vec yes, Vec no)
{
    return hn::IfVecThenElse(mask, yes, no);
}

/// v >> bits for every lane, zeros from above; bits 0 to 63.
HWY_INLINE Vec shift_right(Vec v, int bits)
{
    return hn::ShiftRightSame(v, bits);
}

/// Whether a signed number is shifted right as fast as an unsigned one.
inline constexpr bool shifts_signed = HWY_TARGET <= HWY_AVX3 || HWY_TARGET == HWY_NEON;

HWY_INLINE Vec shift_right_signed(Vec v, int bits)
{
    return hn::BitCast(Words(), hn::ShiftRightSame(hn::BitCast(SignedWords(), v), bits));
}

/// The product of unsigned words.
struct DoubleWord
{
    Vec high;
    Vec low;
};

HWY_INLINE Vec multiply_halves(Vec a, Vec b) ///< of the lower halves
{
    const hn::Repartition<std::uint32_t, Words> d32;
    return hn::BitCast(Words(), hn::MulEven(hn::BitCast(d32, a), hn::BitCast(d32, b)));
}

/// a * b modulo 2^64; b below 2^32.
HWY_INLINE Vec multiply_low(Vec a, Vec b)
{
    return hn::Add(multiply_halves(a, b),
                   hn::ShiftLeft<32>(multiply_halves(hn::ShiftRight<32>(a), b)));
}

/// The compiler finds that a square has two equal parts.
HWY_INLINE DoubleWord multiply(Vec a, Vec b)
{
    const Vec half = all(0xFFFF'FFFF);
    const Vec a1 = hn::ShiftRight<32>(a);
    const Vec b1 = hn::ShiftRight<32>(b);
    const Vec low = multiply_halves(a, b);
    const Vec middle = hn::Add(multiply_halves(a1, b), hn::ShiftRight<32>(low));
    const Vec other = hn::Add(multiply_halves(b1, a), hn::And(middle, half));
    const Vec high = hn::Add(multiply_halves(a1, b1),
                             hn::Add(hn::ShiftRight<32>(middle), hn::ShiftRight<32>(other)));
    return {high, hn::Or(hn::ShiftLeft<32>(other), hn::And(low, half))};
}

/// The lower word of a product shifted right by 1 to 63.
template <int bits>
HWY_INLINE Vec shifted(const DoubleWord& a)
{
    return hn::Or(hn::ShiftLeft<64 - bits>(a.high), hn::ShiftRight<bits>(a.low));
}

} // namespace raymarch::engine::mandelbulb::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
