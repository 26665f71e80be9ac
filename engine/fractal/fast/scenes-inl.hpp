// SPDX-License-Identifier: MIT
/// @file
/// The stage of scenes.hpp in vectors, and what a ray carries from step to step in each scene. All
/// scenes but one repeat, so that a ray needs the fraction of its position and little else: lanes
/// of 16 bits, twice as many as of words.
#if defined(RAYMARCH_ENGINE_FRACTAL_FAST_SCENES) == defined(HWY_TARGET_TOGGLE)
#ifdef RAYMARCH_ENGINE_FRACTAL_FAST_SCENES
#undef RAYMARCH_ENGINE_FRACTAL_FAST_SCENES
#else
#define RAYMARCH_ENGINE_FRACTAL_FAST_SCENES
#endif

#include "engine/fractal/fast/lanes-inl.hpp"
#include "engine/fractal/fast/ray_generator-inl.hpp"
#include "engine/fractal/ray_marcher.hpp"

#include <array>

HWY_BEFORE_NAMESPACE();
namespace raymarch::engine::fractal::fast::HWY_NAMESPACE
{

inline constexpr std::size_t axes = 3;
template <typename T>
using Axes = std::array<T, axes>;

[[nodiscard]] constexpr Axes<Number> axes_of(const Point& p) noexcept
{
    return {p.x, p.y, p.z};
}

template <class V>
HWY_INLINE V middle(const Axes<V>& a)
{
    return hn::Max(hn::Min(a[0], a[1]), hn::Min(hn::Max(a[0], a[1]), a[2]));
}

template <class V>
HWY_INLINE V largest(const Axes<V>& a)
{
    return hn::Max(hn::Max(a[0], a[1]), a[2]);
}

HWY_INLINE Vec<I16> as_signed(Vec<U16> v)
{
    return hn::BitCast(I16(), v);
}

/// |v| of signed lanes; |-32768| is 32768.
HWY_INLINE Vec<U16> absolute(Vec<U16> v)
{
    return hn::BitCast(U16(), hn::Abs(as_signed(v)));
}

/// Rays in a scene that repeats: what stands behind the point of their positions.
struct RepeatingRays
{
    using Tag = U16;
    static constexpr std::size_t parts = 2; ///< vectors of directions that fill one of rays
    static constexpr std::size_t fields = 3 * axes;

    Axes<Vec<U16>> fraction; ///< in a scene with cells less a half, which makes it a signed number
    Axes<Vec<U16>> low;      ///< of the direction: the lower 16 bits
    Axes<Vec<U16>> high;     ///< and those above, signed

    HWY_INLINE void aim(const std::array<Directions, parts>& to)
    {
        const U16 d;
        const auto set = [&](std::size_t axis, Vec<I32> first, Vec<I32> second) {
            low[axis] = hn::ConcatEven(d, hn::BitCast(d, second), hn::BitCast(d, first));
            high[axis] = hn::ConcatOdd(d, hn::BitCast(d, second), hn::BitCast(d, first));
        };
        set(0, to[0].x, to[1].x);
        set(1, to[0].y, to[1].y);
        set(2, to[0].z, to[1].z);
    }

    template <typename Visit>
    HWY_INLINE void each_field(Visit visit)
    {
        for (std::size_t axis = 0; axis < axes; ++axis) {
            visit(fraction[axis]);
            visit(low[axis]);
            visit(high[axis]);
        }
    }

    /// p + mul(d, s) modulo 1: with d = 65536 high + low, mul(d, s) is high * s + floor(low * s).
    HWY_INLINE void advance(std::size_t axis, Vec<U16> s)
    {
        fraction[axis] =
            hn::Add(fraction[axis], hn::Add(hn::MulHigh(low[axis], s), hn::Mul(high[axis], s)));
    }

    /// Which of the `alive` go on. Distances below 0 are given as 0, and none is above five.
    HWY_INLINE Vec<U16> going_on(Vec<U16> s, Vec<U16> alive)
    {
        const auto hit = hn::Eq(hn::SaturatedSub(s, Set<U16>(hit_limit.raw() - 1)), Set<U16>(0));
        return hn::AndNot(hn::VecFromMask(U16(), hit), alive);
    }

    [[nodiscard]] HWY_INLINE Vec<U16> missed() const { return Set<U16>(0); }

    /// The texture needs all of a position but its integer.
    [[nodiscard]] HWY_INLINE Vec<U16> texel(std::size_t axis) const { return fraction[axis]; }
    [[nodiscard]] static HWY_INLINE Vec<U16> shortened(Vec<U16> v) { return v; }
};

/// The infinite cubes need no cell.
struct CubesRays : RepeatingRays
{
    HWY_INLINE void start(const Point& p)
    {
        for (std::size_t axis = 0; axis < axes; ++axis)
            fraction[axis] = Set<U16>(axes_of(p)[axis].raw());
    }

    /// fract(p + half) - half is the fraction as a signed number.
    [[nodiscard]] HWY_INLINE Vec<U16> distance() const
    {
        return hn::SaturatedSub(largest(Axes<Vec<U16>>{absolute(fraction[0]), absolute(fraction[1]),
                                                       absolute(fraction[2])}),
                                Set<U16>(quarter.raw()));
    }

    HWY_INLINE void step(Vec<U16> s)
    {
        for (std::size_t axis = 0; axis < axes; ++axis)
            advance(axis, s);
    }
};

/// Rays in a scene that repeats, but not with every integer.
struct CellRays : RepeatingRays
{
    static constexpr std::size_t fields = RepeatingRays::fields + axes;

    Axes<Vec<U16>> cell; ///< what the scene needs of the integers

    template <typename Visit>
    HWY_INLINE void each_field(Visit visit)
    {
        RepeatingRays::each_field(visit);
        for (Vec<U16>& c : cell)
            visit(c);
    }

    /// -1 for a direction that leads down the axis.
    [[nodiscard]] HWY_INLINE Vec<U16> downwards(std::size_t axis) const
    {
        return hn::BitCast(U16(), hn::BroadcastSignBit(as_signed(high[axis])));
    }

    /// Advances, and returns -1 where a step upwards has come to the next integer, and where a step
    /// downwards has not. Steps are shorter than 1, so they pass one integer at most; then the
    /// fraction is smaller than before upwards, and larger downwards. No step downwards leaves the
    /// fraction as it was, since it is floored.
    HWY_INLINE Vec<U16> advance_over(std::size_t axis, Vec<U16> s)
    {
        const Vec<U16> before = fraction[axis];
        advance(axis, s);
        return hn::BitCast(
            U16(), hn::VecFromMask(I16(), hn::Gt(as_signed(before), as_signed(fraction[axis]))));
    }
};

/// The sponge needs to know whether the integer is odd: `cell` is -1 where it is even.
struct MengerRays : CellRays
{
    HWY_INLINE void start(const Point& p)
    {
        for (std::size_t axis = 0; axis < axes; ++axis) {
            const std::int32_t raw = axes_of(p)[axis].raw();
            fraction[axis] = Set<U16>(raw - half.raw());
            cell[axis] = Set<U16>((raw & one.raw()) != 0 ? 0 : -1);
        }
    }

    [[nodiscard]] HWY_INLINE Vec<U16> distance() const
    {
        const auto folded = [](auto fold) {
            return middle(Axes<decltype(fold(std::size_t{0}))>{fold(0), fold(1), fold(2)});
        };
        // The first generation folds the odd and the even units about the integer between them.
        // The lowest bit is lost anyway: all is halved here, and less a quarter.
        const auto first = folded([&](std::size_t axis) {
            const auto halved = hn::ShiftRight<1>(as_signed(fraction[axis]));
            const auto even = as_signed(cell[axis]);
            return hn::Sub(hn::Xor(halved, even), even);
        });
        constexpr std::int32_t generation_1 = 29492 / 2 - quarter.raw();
        const Vec<U16> s1 = hn::BitCast(
            U16(),
            hn::ShiftLeft<1>(hn::Max(hn::Sub(first, Set<I16>(generation_1)), hn::Zero(I16()))));
        // | |x - 1/2| - 1/4 | is |fract(2 x) / 2 - 1/4|.
        const Axes<Vec<U16>> from_half = {absolute(fraction[0]), absolute(fraction[1]),
                                          absolute(fraction[2])};
        const Vec<U16> s2 = hn::SaturatedSub(middle(from_half), Set<U16>(18569));
        const Vec<U16> third_generation = folded([&](std::size_t axis) {
            return absolute(hn::Sub(from_half[axis], Set<U16>(quarter.raw())));
        });
        const Vec<U16> s3 = hn::SaturatedSub(third_generation, Set<U16>(11906));
        const Vec<U16> fourth = folded([&](std::size_t axis) { // eight times
            return absolute(hn::Xor(hn::ShiftLeft<3>(fraction[axis]), Set<U16>(half.raw())));
        });
        const Vec<U16> s4 = hn::ShiftRight<3>(hn::SaturatedSub(fourth, Set<U16>(8 * 3277)));
        return hn::Max(hn::Max(s1, s2), hn::Max(s3, s4));
    }

    HWY_INLINE void step(Vec<U16> s)
    {
        for (std::size_t axis = 0; axis < axes; ++axis)
            cell[axis] = hn::Xor(cell[axis], hn::Xor(advance_over(axis, s), downwards(axis)));
    }
};

/// The maze names a cell by its middle: `cell` is 2 floor(p) + 1, which only grows beyond what a
/// word holds, and is cut where that matters.
struct MazeRays : CellRays
{
    HWY_INLINE void start(const Point& p)
    {
        for (std::size_t axis = 0; axis < axes; ++axis) {
            const std::int32_t raw = axes_of(p)[axis].raw();
            fraction[axis] = Set<U16>(raw - half.raw());
            cell[axis] = Set<U16>(2 * (raw >> Number::fraction_bits) + 1);
        }
    }

    [[nodiscard]] HWY_INLINE Vec<U16> distance() const
    {
        const Axes<Vec<U16>> a = {absolute(fraction[0]), absolute(fraction[1]),
                                  absolute(fraction[2])};
        // In the middle of a cell no face is nearest: nothing equals 1 there.
        const Vec<U16> nearest = hn::Max(largest(a), Set<U16>(1));
        const auto name = [&](std::size_t axis) { // in halves
            const Vec<U16> side = hn::Or(
                hn::BitCast(U16(), hn::BroadcastSignBit(as_signed(fraction[axis]))), Set<U16>(1));
            const Vec<U16> faces = hn::VecFromMask(U16(), hn::Eq(a[axis], nearest));
            return hn::Add(cell[axis], hn::And(faces, side));
        };
        // Names in halves have seven bits, signed. Times 3/2 they are 49152 raw, or -16384;
        // times 21845 halved and floored, which is 10922 and a floored half; times 1/4, 8192.
        const auto y = hn::ShiftRight<9>(as_signed(hn::ShiftLeft<9>(name(1))));
        const auto hashed_y = hn::Add(hn::Mul(y, Set<I16>(10922)), hn::ShiftRight<1>(y));
        const Vec<U16> hashed_x = hn::ShiftLeft<14>(name(0));
        const Vec<U16> hashed_z = hn::ShiftLeft<13>(name(2));
        const Vec<U16> hash = hn::Add(hn::Sub(hn::BitCast(U16(), hashed_y), hashed_x), hashed_z);

        const auto at_most = [&](Number limit) {
            return hn::Eq(hn::SaturatedSub(hash, Set<U16>(limit.raw())), Set<U16>(0));
        };
        const Vec<U16> across =
            hn::IfThenElse(at_most(third), hn::Max(a[0], a[1]),
                           hn::IfThenElse(at_most(half), hn::Max(a[1], a[2]), hn::Max(a[0], a[2])));
        return hn::SaturatedSub(across, Set<U16>(sixteenth.raw()));
    }

    HWY_INLINE void step(Vec<U16> s)
    {
        for (std::size_t axis = 0; axis < axes; ++axis) {
            const Vec<U16> cells = hn::Sub(downwards(axis), advance_over(axis, s));
            cell[axis] = hn::Add(cell[axis], hn::Add(cells, cells));
        }
    }
};

/// The one cube does not repeat. No step wraps: it begins within 5.5 of the middle, else the ray
/// was lost, and its length is at most five times `longest`.
struct CubeRays
{
    using Tag = I32;
    using HalfTag = hn::Rebind<std::uint16_t, I32>;
    static constexpr std::size_t parts = 1;
    static constexpr std::size_t fields = 2 * axes + 1;

    Axes<Vec<I32>> position;
    Axes<Vec<I32>> direction;
    Vec<I32> lost; ///< -1 for a ray that has come too far from the cube

    HWY_INLINE void aim(const std::array<Directions, parts>& to)
    {
        lost = hn::Zero(I32());
        direction = {to[0].x, to[0].y, to[0].z};
    }

    template <typename Visit>
    HWY_INLINE void each_field(Visit visit)
    {
        for (std::size_t axis = 0; axis < axes; ++axis) {
            visit(position[axis]);
            visit(direction[axis]);
        }
        visit(lost);
    }

    HWY_INLINE void start(const Point& p)
    {
        for (std::size_t axis = 0; axis < axes; ++axis)
            position[axis] = Set<I32>(axes_of(p)[axis].raw());
    }

    [[nodiscard]] HWY_INLINE Vec<I32> distance() const
    {
        const Axes<Vec<I32>> a = {hn::Abs(position[0]), hn::Abs(position[1]), hn::Abs(position[2])};
        return hn::Sub(largest(a), Set<I32>(half.raw()));
    }

    HWY_INLINE void step(Vec<I32> s)
    {
        for (std::size_t axis = 0; axis < axes; ++axis)
            position[axis] =
                hn::Add(position[axis], product<Number::fraction_bits>(direction[axis], s));
    }

    HWY_INLINE Vec<I32> going_on(Vec<I32> s, Vec<I32> alive)
    {
        const I32 d;
        const Vec<I32> far = hn::And(alive, hn::VecFromMask(d, hn::Gt(s, Set<I32>(five.raw()))));
        lost = hn::Or(lost, far);
        const auto apart = hn::Gt(s, Set<I32>(hit_limit.raw() - 1));
        return hn::AndNot(far, hn::And(alive, hn::VecFromMask(d, apart)));
    }

    [[nodiscard]] HWY_INLINE Vec<HalfTag> missed() const { return shortened(lost); }
    [[nodiscard]] HWY_INLINE Vec<HalfTag> texel(std::size_t axis) const
    {
        return shortened(position[axis]);
    }
    [[nodiscard]] static HWY_INLINE Vec<HalfTag> shortened(Vec<I32> v)
    {
        return hn::TruncateTo(HalfTag(), hn::BitCast(U32(), v));
    }
};

} // namespace raymarch::engine::fractal::fast::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
