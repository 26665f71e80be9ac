// SPDX-License-Identifier: MIT
/// @file
/// The stages of shading.hpp and display.hpp in vectors. Compiled once for each instruction set.
#if defined(RAYMARCH_ENGINE_FRACTAL_FAST_SHADING) == defined(HWY_TARGET_TOGGLE)
#ifdef RAYMARCH_ENGINE_FRACTAL_FAST_SHADING
#undef RAYMARCH_ENGINE_FRACTAL_FAST_SHADING
#else
#define RAYMARCH_ENGINE_FRACTAL_FAST_SHADING
#endif

#include "engine/fractal/display.hpp"
#include "engine/fractal/fast/lanes-inl.hpp"
#include "engine/fractal/ray_marcher.hpp"

HWY_BEFORE_NAMESPACE();
namespace raymarch::engine::fractal::HWY_NAMESPACE
{

/// How a ray ended: its depth as it is shaded, which is `dark` for a miss, and 256 times the
/// queries that it took.
using Ending = std::uint16_t;
inline constexpr Ending dark =
    max_depth; ///< the deepest hit is as black as a miss, with dither too
inline constexpr int queries_shift = 8;

/// brick() in lanes of 16 bits; of the positions only the lowest 13 bits count, which are 16 bits
/// after the scaling.
template <class D, typename Vec = hn::Vec<D>>
HWY_INLINE Vec brick(D d, Vec x, Vec y, Vec z, Vec depth)
{
    const auto set = [&](std::int32_t v) { return hn::Set(d, static_cast<std::uint16_t>(v)); };
    // |c - half| > tenth: c is not in the tenths beside the middle.
    const auto beyond_joint = [&](Vec c) {
        const Vec above = hn::Sub(c, set(half.raw() - tenth.raw()));
        return hn::SaturatedSub(above, set(2 * tenth.raw()));
    };
    // Bit 16 of 16 y - half is bit 12 of y - 1/32. In an odd course u is a half more and not
    // reduced, so that |u - half| is u itself.
    const Vec course = hn::Sub(y, set(half.raw() >> 4));
    const auto odd_course = hn::TestBit(course, set(1 << 12));
    const Vec u = hn::ShiftLeft<3>(hn::Add(x, z));
    const Vec across =
        hn::IfThenElse(odd_course, hn::SaturatedSub(u, set(tenth.raw())), beyond_joint(u));
    const Vec along = beyond_joint(hn::ShiftLeft<4>(y));
    const auto inside = hn::Not(hn::Or(hn::Eq(across, set(0)), hn::Eq(along, set(0))));
    return hn::IfThenElse(inside, hn::And(hn::Sub(depth, set(2)), set(max_depth)), depth);
}

} // namespace raymarch::engine::fractal::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
