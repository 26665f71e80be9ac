// SPDX-License-Identifier: MIT
// The shading stage on vectors. Included by kernel.cpp alone, once for each instruction set: no
// include guard.

HWY_BEFORE_NAMESPACE();
namespace raymarch::engine::marcher::HWY_NAMESPACE
{

HWY_INLINE Ints brightness(const Points& normal, const Points& light)
{
    // The sum is below 2^50: bits 24 to 55 hold it with its sign.
    const Wide sum = add(add(multiply(normal.x, light.x), multiply(normal.y, light.y)),
                         multiply(normal.z, light.z));
    const Ints dot = as_ints(lower({hn::ShiftRight<24>(sum.even), hn::ShiftRight<24>(sum.odd)}));
    const Ints diffuse = hn::Max(dot, all(0));
    const Ints sky = hn::Max(normal.y, all(0));
    return all(ratio(1, 8).raw()) + hn::ShiftRight<3>(sky) +
           hn::ShiftRight<2>(diffuse + hn::Add(diffuse, diffuse));
}

/// 8 bits: (C * brightness) >> 26 is the upper half of (C << 6) * brightness. It is below 256,
/// as brightness is at most 2^24 + 4, so nothing has to be held.
HWY_INLINE Words channel(std::uint16_t colour, Words brightness)
{
    return upper(multiply(all_words(std::uint32_t{colour} << 6), brightness));
}

/// Red, green and blue from the lowest byte on.
HWY_INLINE Words shade(const std::array<std::uint16_t, 3>& colour, Ints brightness)
{
    const Words b = as_words(brightness);
    return hn::Or(channel(colour[0], b), hn::Or(hn::ShiftLeft<8>(channel(colour[1], b)),
                                                hn::ShiftLeft<16>(channel(colour[2], b))));
}

} // namespace raymarch::engine::marcher::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
