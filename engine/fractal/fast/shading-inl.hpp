// SPDX-License-Identifier: MIT
/// @file
/// The stages of shading.hpp and display.hpp in vectors.
#if defined(RAYMARCH_ENGINE_FRACTAL_FAST_SHADING) == defined(HWY_TARGET_TOGGLE)
#ifdef RAYMARCH_ENGINE_FRACTAL_FAST_SHADING
#undef RAYMARCH_ENGINE_FRACTAL_FAST_SHADING
#else
#define RAYMARCH_ENGINE_FRACTAL_FAST_SHADING
#endif

#include "engine/fractal/display.hpp"
#include "engine/fractal/fast/lanes-inl.hpp"
#include "engine/fractal/ray_marcher.hpp"
#include "engine/image.hpp"

#include <array>

HWY_BEFORE_NAMESPACE();
namespace raymarch::engine::fractal::fast::HWY_NAMESPACE
{

/// How a ray ended: its depth as it is shaded, which is `dark` for a miss, and 256 times the
/// queries that it took.
using Ending = std::uint16_t;
inline constexpr Ending dark =
    max_depth; ///< the deepest hit is as black as a miss, with dither too
inline constexpr int queries_shift = 8;

/// brick() in lanes of 16 bits; of the positions only the lowest 13 bits count, which are 16 bits
/// after the scaling.
template <class D, class V = Vec<D>>
HWY_INLINE V brick(D /*d*/, V x, V y, V z, V depth)
{
    // |c - half| > tenth: c is not in the tenths beside the middle.
    const auto beyond_joint = [&](V c) {
        const V above = hn::Sub(c, Set<D>(half.raw() - tenth.raw()));
        return hn::SaturatedSub(above, Set<D>(2 * tenth.raw()));
    };
    // Bit 16 of 16 y - half is bit 12 of y - 1/32. In an odd course u is a half more and not
    // reduced, so that |u - half| is u itself.
    const V course = hn::Sub(y, Set<D>(half.raw() >> 4));
    const auto odd_course = hn::TestBit(course, Set<D>(1 << 12));
    const V u = hn::ShiftLeft<3>(hn::Add(x, z));
    const V across =
        hn::IfThenElse(odd_course, hn::SaturatedSub(u, Set<D>(tenth.raw())), beyond_joint(u));
    const V along = beyond_joint(hn::ShiftLeft<4>(y));
    const auto inside = hn::Not(hn::Or(hn::Eq(across, Set<D>(0)), hn::Eq(along, Set<D>(0))));
    return hn::IfThenElse(inside, hn::And(hn::Sub(depth, Set<D>(2)), Set<D>(max_depth)), depth);
}

/// The colours of the greys by channel, and whether they are dithered.
struct Paint
{
    alignas(16) std::array<std::array<std::uint8_t, 16>, bytes_per_pixel> channels;
    bool dither;
};

[[nodiscard]] inline Paint paint_of(const Palette& palette, bool dither) noexcept
{
    Paint paint{.channels = {}, .dither = dither};
    for (std::size_t grey = 0; grey < palette.size(); ++grey)
        for (std::size_t channel = 0; channel < bytes_per_pixel; ++channel)
            paint.channels[channel][grey] = palette[grey][channel];
    return paint;
}

/// Which pixels of a line are odd, by x + y.
struct Parity
{
    bool first;
    bool alternates;
};

/// grey() of a vector of pixels, and its colours: red, green, blue to `rgb`.
HWY_INLINE void show(const Paint& paint, Parity parity, const Ending* endings, std::uint8_t* rgb)
{
    const U8 d;
    const U16 d16;
    const auto levels = hn::ConcatEven(d, hn::BitCast(d, hn::LoadU(d16, endings + hn::Lanes(d16))),
                                       hn::BitCast(d, hn::LoadU(d16, endings)));
    // 255 in odd pixels
    const auto second = hn::BitCast(d, Set<U16>(0xFF00));
    const auto alternating = parity.alternates ? second : hn::Zero(d);
    const auto odd = parity.first ? hn::Not(alternating) : alternating;

    const auto level =
        hn::And(hn::BitCast(d, hn::ShiftRight<1>(hn::BitCast(d16, levels))), Set<U8>(15));
    const auto darker = hn::AndNot(hn::VecFromMask(d, hn::Eq(level, Set<U8>(15))),
                                   hn::And(hn::And(levels, Set<U8>(1)), odd));
    const auto grey = hn::Sub(hn::Sub(Set<U8>(15), level), paint.dither ? darker : hn::Zero(d));
    const auto channel = [&](std::size_t i) {
        return hn::TableLookupBytes(hn::LoadDup128(d, paint.channels[i].data()), grey);
    };
    hn::StoreInterleaved3(channel(0), channel(1), channel(2), d, rgb);
}

} // namespace raymarch::engine::fractal::fast::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
