// SPDX-License-Identifier: MIT
// Vectors of 32-bit lanes and the 64-bit numbers between them. Included by kernel.cpp alone, once
// for each instruction set: no include guard.

HWY_BEFORE_NAMESPACE();
namespace raymarch::engine::marcher::HWY_NAMESPACE
{

namespace hn = hwy::HWY_NAMESPACE;

using IntTag = hn::ScalableTag<std::int32_t>;
using WordTag = hn::ScalableTag<std::uint32_t>;
using LongTag = hn::ScalableTag<std::uint64_t>;
using Ints = hn::Vec<IntTag>;    ///< raws
using Words = hn::Vec<WordTag>;  ///< unsigned 32-bit numbers
using Longs = hn::Vec<LongTag>;  ///< half as many 64-bit numbers
using Chosen = hn::Mask<IntTag>; ///< one truth a lane

constexpr std::size_t lanes = hn::MaxLanes(IntTag());

/// One 64-bit number a lane, in two halves as the widening multiplication gives them.
struct Wide
{
    Longs even;
    Longs odd;
};

struct Points
{
    Ints x;
    Ints y;
    Ints z;
};

HWY_INLINE Ints all(std::int32_t value)
{
    return hn::Set(IntTag(), value);
}

HWY_INLINE Words all_words(std::uint32_t value)
{
    return hn::Set(WordTag(), value);
}

HWY_INLINE Ints as_ints(Words v)
{
    return hn::BitCast(IntTag(), v);
}

HWY_INLINE Words as_words(Ints v)
{
    return hn::BitCast(WordTag(), v);
}

HWY_INLINE Points add(const Points& a, const Points& b)
{
    return {a.x + b.x, a.y + b.y, a.z + b.z};
}

HWY_INLINE Points subtract(const Points& a, const Points& b)
{
    return {a.x - b.x, a.y - b.y, a.z - b.z};
}

HWY_INLINE Points all(const Point& p)
{
    return {all(p.x.raw()), all(p.y.raw()), all(p.z.raw())};
}

/// The odd lanes where the even ones were; multiplications look only there.
template <class V>
HWY_INLINE V odd_lanes(V v)
{
    return hn::BitCast(hn::DFromV<V>(), hn::ShiftRight<32>(hn::BitCast(LongTag(), v)));
}

HWY_INLINE Longs multiply_even(Ints a, Ints b)
{
    return hn::BitCast(LongTag(), hn::MulEven(a, b));
}

HWY_INLINE Longs multiply_even(Words a, Words b)
{
    return hn::MulEven(a, b);
}

/// The exact products.
template <class V>
HWY_INLINE Wide multiply(V a, V b)
{
    return {multiply_even(a, b), multiply_even(odd_lanes(a), odd_lanes(b))};
}

HWY_INLINE Wide add(const Wide& a, const Wide& b)
{
    return {a.even + b.even, a.odd + b.odd};
}

/// Shifts right by a number for each lane; the upper 32 bits of the result must not matter.
HWY_INLINE Wide shift_right(const Wide& v, Words by)
{
    const Longs counts = hn::BitCast(LongTag(), by);
    const Longs low = hn::And(counts, hn::Set(LongTag(), 0xFFFF'FFFFU));
    return {v.even >> low, v.odd >> hn::ShiftRight<32>(counts)};
}

/// The lower 32 bits of each.
HWY_INLINE Words lower(const Wide& v)
{
    return hn::OddEven(hn::BitCast(WordTag(), hn::ShiftLeft<32>(v.odd)),
                       hn::BitCast(WordTag(), v.even));
}

/// The upper 32 bits of each.
HWY_INLINE Words upper(const Wide& v)
{
    return hn::OddEven(hn::BitCast(WordTag(), v.odd),
                       hn::BitCast(WordTag(), hn::ShiftRight<32>(v.even)));
}

} // namespace raymarch::engine::marcher::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
