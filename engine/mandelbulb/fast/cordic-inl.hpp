// SPDX-License-Identifier: MIT
/// @file
/// cordic.hpp in vectors. What is negated there by a sign is held here as it was before: `u` is y
/// or, where `negative` is all ones, its complement, so that it is never below 0; docs/engine/
/// mandelbulb.md shows that the steps are the same.
#if defined(RAYMARCH_ENGINE_MANDELBULB_FAST_CORDIC) == defined(HWY_TARGET_TOGGLE)
#ifdef RAYMARCH_ENGINE_MANDELBULB_FAST_CORDIC
#undef RAYMARCH_ENGINE_MANDELBULB_FAST_CORDIC
#else
#define RAYMARCH_ENGINE_MANDELBULB_FAST_CORDIC
#endif

#include "engine/mandelbulb/fast/lanes-inl.hpp"
#include "engine/mandelbulb/tables.hpp"

HWY_BEFORE_NAMESPACE();
namespace raymarch::engine::mandelbulb::fast::HWY_NAMESPACE
{

/// N steps share these numbers.
struct Cordic
{
    int steps;
    std::uint64_t gain;
    std::uint64_t turned; ///< the sum of the angles of all steps

    explicit Cordic(int n) : steps(n), gain(static_cast<std::uint64_t>(gain_of(n))), turned(0)
    {
        for (int i = 0; i < n; ++i)
            turned += angles[static_cast<std::size_t>(i)];
    }
};

inline constexpr std::uint64_t top_bit = std::uint64_t{1} << 63;

/// (v * gain) >> 63 of a signed v: with 2^63 added to v the product has gain << 63 more.
HWY_INLINE Vec<U64> scaled(Vec<U64> v, std::uint64_t gain)
{
    const Vec<U64> raised = hn::Xor(v, Set<U64>(top_bit));
    return hn::Sub(shifted<63>(multiply(raised, Set<U64>(gain))), Set<U64>(gain));
}

struct PolarBatch
{
    Batch magnitude;
    Batch angle;
};

HWY_INLINE PolarBatch to_polar(const Cordic& with, Batch x, const Batch& y)
{
    Batch u;
    Batch negative;
    Batch angle;
    Batch back; // the angles of the steps that turned backwards
    for (std::size_t j = 0; j < in_flight; ++j) {
        const Vec<U64> left = sign_of(x[j]);
        x[j] = hn::Sub(hn::Xor(x[j], left), left);
        const Vec<U64> above = hn::Sub(hn::Xor(y[j], left), left);
        angle[j] = hn::And(left, Set<U64>(top_bit));
        negative[j] = sign_of(above);
        u[j] = hn::Xor(above, negative[j]);
        back[j] = hn::Zero(U64());
    }
    for (int i = 0; i < with.steps; ++i) {
        const Vec<U64> turn = Set<U64>(angles[static_cast<std::size_t>(i)]);
        for (std::size_t j = 0; j < in_flight; ++j) {
            const Vec<U64> across = hn::ShiftRightSame(x[j], i);
            const Vec<U64> along = hn::ShiftRightSame(u[j], i);
            back[j] = hn::Add(back[j], hn::And(negative[j], turn));
            x[j] = hn::Add(hn::Sub(x[j], negative[j]), along);
            const Vec<U64> next = hn::Sub(u[j], across);
            const Vec<U64> flipped = sign_of(next);
            u[j] = hn::Xor(next, flipped);
            negative[j] = hn::Xor(negative[j], flipped);
        }
    }
    PolarBatch polar;
    for (std::size_t j = 0; j < in_flight; ++j) {
        polar.magnitude[j] = scaled(x[j], with.gain);
        polar.angle[j] =
            hn::Sub(hn::Add(angle[j], Set<U64>(with.turned)), hn::Add(back[j], back[j]));
    }
    return polar;
}

struct CartesianBatch
{
    Batch x;
    Batch y;
};

/// Where the machine shifts no signed words, x and y are held with 2^63 added: their shifts then
/// have 2^(63-i) too much, which is taken away again.
HWY_INLINE CartesianBatch to_cartesian(const Cordic& with, const Batch& r, const Batch& angle)
{
    const Vec<U64> raise = Set<U64>(shifts_signed ? 0 : top_bit);
    Batch x;
    Batch y;
    Batch rest; // of the angle
    Batch negative;
    for (std::size_t j = 0; j < in_flight; ++j) {
        const Vec<U64> opposite = sign_of(hn::Xor(angle[j], hn::Add(angle[j], angle[j])));
        const Vec<U64> turned = hn::Xor(angle[j], hn::And(opposite, Set<U64>(top_bit)));
        const Vec<U64> start = hn::Sub(hn::Xor(scaled(r[j], with.gain), opposite), opposite);
        negative[j] = sign_of(turned);
        rest[j] = hn::Xor(turned, negative[j]);
        x[j] = hn::Xor(start, raise);
        y[j] = hn::Xor(negative[j], raise);
    }
    for (int i = 0; i < with.steps; ++i) {
        const Vec<U64> turn = Set<U64>(angles[static_cast<std::size_t>(i)]);
        const Vec<U64> excess = Set<U64>(top_bit >> i);
        for (std::size_t j = 0; j < in_flight; ++j) {
            const Vec<U64> left = hn::Sub(rest[j], turn);
            const Vec<U64> flipped = sign_of(left);
            rest[j] = hn::Xor(left, flipped);
            if constexpr (shifts_signed) {
                const Vec<U64> across = shift_right_signed(x[j], i);
                const Vec<U64> along = shift_right_signed(y[j], i);
                x[j] = hn::Sub(hn::Add(x[j], negative[j]), along);
                y[j] = hn::Xor(hn::Add(y[j], across), flipped);
            } else {
                const Vec<U64> across = hn::ShiftRightSame(x[j], i);
                const Vec<U64> along = hn::ShiftRightSame(y[j], i);
                x[j] = hn::Sub(hn::Add(x[j], hn::Add(negative[j], excess)), along);
                y[j] = hn::Xor(hn::Add(y[j], hn::Sub(across, excess)), flipped);
            }
            negative[j] = hn::Xor(negative[j], flipped);
        }
    }
    for (std::size_t j = 0; j < in_flight; ++j) {
        x[j] = hn::Xor(x[j], raise);
        y[j] = hn::Xor(hn::Xor(y[j], negative[j]), raise);
    }
    return {x, y};
}

} // namespace raymarch::engine::mandelbulb::fast::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
