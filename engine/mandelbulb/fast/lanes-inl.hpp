// SPDX-License-Identifier: MIT
/// @file
/// The vectors that the Mandelbulb's kernels compute in: 64-bit words, a coordinate of Q8.57 or an
/// angle a lane.
#if defined(RAYMARCH_ENGINE_MANDELBULB_FAST_LANES) == defined(HWY_TARGET_TOGGLE)
#ifdef RAYMARCH_ENGINE_MANDELBULB_FAST_LANES
#undef RAYMARCH_ENGINE_MANDELBULB_FAST_LANES
#else
#define RAYMARCH_ENGINE_MANDELBULB_FAST_LANES
#endif

#include "engine/fast/vectors-inl.hpp"

#include <array>
#include <cstddef>
#include <cstdint>

HWY_BEFORE_NAMESPACE();
namespace raymarch::engine::mandelbulb::fast::HWY_NAMESPACE
{

using namespace engine::fast::HWY_NAMESPACE;

/// Vectors in flight: a step of CORDIC waits for the one before it.
inline constexpr std::size_t in_flight = 2;
inline constexpr std::size_t batch = in_flight * lanes<U64>; ///< lanes that are computed together
using Batch = std::array<Vec<U64>, in_flight>;

HWY_INLINE Batch load(const std::uint64_t* from)
{
    Batch values;
    for (std::size_t j = 0; j < in_flight; ++j)
        values[j] = hn::LoadU(U64(), from + j * lanes<U64>);
    return values;
}

HWY_INLINE void store(const Batch& values, std::uint64_t* to)
{
    for (std::size_t j = 0; j < in_flight; ++j)
        hn::StoreU(values[j], U64(), to + j * lanes<U64>);
}

/// All ones for a negative number, else 0, as sign_of() of the scalar stages.
HWY_INLINE Vec<U64> sign_of(Vec<U64> a)
{
    return hn::BitCast(U64(), hn::BroadcastSignBit(hn::BitCast(I64(), a)));
}

/// a > b, as signed numbers: all ones or 0.
HWY_INLINE Vec<U64> greater(Vec<U64> a, Vec<U64> b)
{
    const I64 d;
    return hn::BitCast(U64(), hn::VecFromMask(d, hn::Gt(hn::BitCast(d, a), hn::BitCast(d, b))));
}

/// True if a signed number is shifted right as fast as an unsigned one.
inline constexpr bool shifts_signed = HWY_TARGET <= HWY_AVX3 || HWY_TARGET == HWY_NEON;

HWY_INLINE Vec<U64> shift_right_signed(Vec<U64> v, int bits)
{
    return hn::BitCast(U64(), hn::ShiftRightSame(hn::BitCast(I64(), v), bits));
}

/// The product of unsigned words.
struct DoubleWord
{
    Vec<U64> high;
    Vec<U64> low;
};

HWY_INLINE Vec<U64> multiply_halves(Vec<U64> a, Vec<U64> b) ///< multiplies the lower halves
{
    const hn::Repartition<std::uint32_t, U64> d32;
    return hn::BitCast(U64(), hn::MulEven(hn::BitCast(d32, a), hn::BitCast(d32, b)));
}

/// a * b modulo 2^64; b below 2^32.
HWY_INLINE Vec<U64> multiply_low(Vec<U64> a, Vec<U64> b)
{
    return hn::Add(multiply_halves(a, b),
                   hn::ShiftLeft<32>(multiply_halves(hn::ShiftRight<32>(a), b)));
}

/// The compiler finds that a square has two equal parts.
HWY_INLINE DoubleWord multiply(Vec<U64> a, Vec<U64> b)
{
    const Vec<U64> half = Set<U64>(0xFFFF'FFFF);
    const Vec<U64> a1 = hn::ShiftRight<32>(a);
    const Vec<U64> b1 = hn::ShiftRight<32>(b);
    const Vec<U64> low = multiply_halves(a, b);
    const Vec<U64> middle = hn::Add(multiply_halves(a1, b), hn::ShiftRight<32>(low));
    const Vec<U64> other = hn::Add(multiply_halves(b1, a), hn::And(middle, half));
    const Vec<U64> high = hn::Add(multiply_halves(a1, b1),
                                  hn::Add(hn::ShiftRight<32>(middle), hn::ShiftRight<32>(other)));
    return {high, hn::Or(hn::ShiftLeft<32>(other), hn::And(low, half))};
}

/// The lower word of a product shifted right by 1 to 63.
template <int bits>
HWY_INLINE Vec<U64> shifted(const DoubleWord& a)
{
    return hn::Or(hn::ShiftLeft<64 - bits>(a.high), hn::ShiftRight<bits>(a.low));
}

} // namespace raymarch::engine::mandelbulb::fast::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
