// SPDX-License-Identifier: MIT
/// @file
/// The shading stage on vectors.
#if defined(RAYMARCH_ENGINE_MARCHER_FAST_SHADING) == defined(HWY_TARGET_TOGGLE)
#ifdef RAYMARCH_ENGINE_MARCHER_FAST_SHADING
#undef RAYMARCH_ENGINE_MARCHER_FAST_SHADING
#else
#define RAYMARCH_ENGINE_MARCHER_FAST_SHADING
#endif

#include "engine/marcher/fast/lanes-inl.hpp"

#include <array>

HWY_BEFORE_NAMESPACE();
namespace raymarch::engine::marcher::fast::HWY_NAMESPACE
{

HWY_INLINE Vec<I32> brightness(const Points& normal, const Points& light)
{
    // The sum is below 2^50: bits 24 to 55 hold it with its sign.
    const Wide sum = add(add(multiply(normal.x, light.x), multiply(normal.y, light.y)),
                         multiply(normal.z, light.z));
    const Vec<I32> dot =
        hn::BitCast(I32(), lower({hn::ShiftRight<24>(sum.even), hn::ShiftRight<24>(sum.odd)}));
    const Vec<I32> diffuse = hn::Max(dot, Set<I32>(0));
    const Vec<I32> sky = hn::Max(normal.y, Set<I32>(0));
    return Set<I32>(ratio(1, 8).raw()) + hn::ShiftRight<3>(sky) +
           hn::ShiftRight<2>(diffuse + hn::Add(diffuse, diffuse));
}

/// 8 bits: (C * brightness) >> 26 is the upper half of (C << 6) * brightness. It is below 256,
/// as brightness is at most 2^24 + 4, so nothing has to be held.
HWY_INLINE Vec<U32> channel(std::uint16_t colour, Vec<U32> brightness)
{
    return upper(multiply(Set<U32>(std::uint32_t{colour} << 6), brightness));
}

/// Red, green and blue from the lowest byte on.
HWY_INLINE Vec<U32> shade(const std::array<std::uint16_t, 3>& colour, Vec<I32> brightness)
{
    const Vec<U32> b = hn::BitCast(U32(), brightness);
    return hn::Or(channel(colour[0], b), hn::Or(hn::ShiftLeft<8>(channel(colour[1], b)),
                                                hn::ShiftLeft<16>(channel(colour[2], b))));
}

} // namespace raymarch::engine::marcher::fast::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
