// SPDX-License-Identifier: MIT
/// @file
/// The vectors that the fractal's kernels compute in, and the products that are exact in them.
/// Compiled once for each instruction set.
#if defined(RAYMARCH_ENGINE_FRACTAL_FAST_LANES) == defined(HWY_TARGET_TOGGLE)
#ifdef RAYMARCH_ENGINE_FRACTAL_FAST_LANES
#undef RAYMARCH_ENGINE_FRACTAL_FAST_LANES
#else
#define RAYMARCH_ENGINE_FRACTAL_FAST_LANES
#endif

#include "engine/fractal/formats.hpp"

#include <hwy/highway.h>

#include <cstddef>
#include <cstdint>

HWY_BEFORE_NAMESPACE();
namespace raymarch::engine::fractal::HWY_NAMESPACE
{

namespace hn = hwy::HWY_NAMESPACE;

/// Whole words, or products of them: 32 bits a lane.
using Wide = hn::ScalableTag<std::int32_t>;
using WideBits = hn::RebindToUnsigned<Wide>;
/// Fractions of words: 16 bits a lane.
using Narrow = hn::ScalableTag<std::uint16_t>;
using NarrowSigned = hn::RebindToSigned<Narrow>;

using WideVec = hn::Vec<Wide>;
using WideBitsVec = hn::Vec<WideBits>;
using NarrowVec = hn::Vec<Narrow>;

/// (a * b >> shift) modulo 2^32, of the exact product; shift from 1 to 32.
template <int shift>
HWY_INLINE WideVec product(WideVec a, WideVec b)
{
    const hn::RepartitionToWide<WideBits> d64;
    const auto odd_half = [&](WideVec v) {
        return hn::BitCast(Wide(), hn::ShiftRight<32>(hn::BitCast(d64, v)));
    };
    const auto even = hn::BitCast(d64, hn::MulEven(a, b));
    const auto odd = hn::BitCast(d64, hn::MulEven(odd_half(a), odd_half(b)));
    return hn::OddEven(hn::BitCast(Wide(), hn::ShiftLeft<32 - shift>(odd)),
                       hn::BitCast(Wide(), hn::ShiftRight<shift>(even)));
}

HWY_INLINE WideVec wide(std::int32_t value)
{
    return hn::Set(Wide(), value);
}

/// Words have 22 bits: raised by ten they wrap by themselves, as a lane does.
inline constexpr int spare_bits = 32 - Number::width;

} // namespace raymarch::engine::fractal::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
