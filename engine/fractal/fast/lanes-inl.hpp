// SPDX-License-Identifier: MIT
/// @file
/// The vectors that the fractal's kernels compute in, and the products that are exact in them.
#if defined(RAYMARCH_ENGINE_FRACTAL_FAST_LANES) == defined(HWY_TARGET_TOGGLE)
#ifdef RAYMARCH_ENGINE_FRACTAL_FAST_LANES
#undef RAYMARCH_ENGINE_FRACTAL_FAST_LANES
#else
#define RAYMARCH_ENGINE_FRACTAL_FAST_LANES
#endif

#include "engine/fast/vectors-inl.hpp"
#include "engine/fractal/formats.hpp"

HWY_BEFORE_NAMESPACE();
namespace raymarch::engine::fractal::fast::HWY_NAMESPACE
{

using namespace engine::fast::HWY_NAMESPACE;

/// (a * b >> shift) modulo 2^32, of the exact product; shift from 1 to 32.
template <int shift>
HWY_INLINE Vec<I32> product(Vec<I32> a, Vec<I32> b)
{
    const hn::RepartitionToWide<U32> d64;
    const auto odd_half = [&](Vec<I32> v) {
        return hn::BitCast(I32(), hn::ShiftRight<32>(hn::BitCast(d64, v)));
    };
    const auto even = hn::BitCast(d64, hn::MulEven(a, b));
    const auto odd = hn::BitCast(d64, hn::MulEven(odd_half(a), odd_half(b)));
    return hn::OddEven(hn::BitCast(I32(), hn::ShiftLeft<32 - shift>(odd)),
                       hn::BitCast(I32(), hn::ShiftRight<shift>(even)));
}

/// Words have 22 bits: raised by ten they wrap by themselves, as a lane does.
inline constexpr int spare_bits = 32 - Number::width;

} // namespace raymarch::engine::fractal::fast::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
