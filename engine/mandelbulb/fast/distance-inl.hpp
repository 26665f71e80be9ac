// SPDX-License-Identifier: MIT
/// @file
/// distance.hpp, logarithm.hpp and division.hpp in vectors.
#if defined(RAYMARCH_ENGINE_MANDELBULB_FAST_DISTANCE) == defined(HWY_TARGET_TOGGLE)
#ifdef RAYMARCH_ENGINE_MANDELBULB_FAST_DISTANCE
#undef RAYMARCH_ENGINE_MANDELBULB_FAST_DISTANCE
#else
#define RAYMARCH_ENGINE_MANDELBULB_FAST_DISTANCE
#endif

#include "engine/mandelbulb/distance.hpp"
#include "engine/mandelbulb/fast/multiplier-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace raymarch::engine::mandelbulb::fast::HWY_NAMESPACE
{

inline constexpr std::uint64_t unit = std::uint64_t{1} << unit_bits;

/// ln r of a radius from 1 on and below 64.
HWY_INLINE Batch logarithm(const Batch& r, int steps)
{
    constexpr int integer_bits = 8; // six, and up to a power of two;
    static constexpr auto table = logarithms_in<unit_bits>();
    Batch mantissa;
    Batch product;
    Batch sum;
    for (std::size_t j = 0; j < in_flight; ++j) {
        const Vec<U64> exponent =
            hn::Sub(bit_length<integer_bits>(hn::ShiftRight<unit_bits>(r[j])), Set<U64>(1));
        mantissa[j] = hn::Shr(r[j], hn::And(exponent, Set<U64>(63))); // below 1: anything
        product[j] = Set<U64>(unit);
        sum[j] = multiply_low(Set<U64>(table[0]), exponent);
    }
    for (int i = 0; i < steps; ++i) {
        const Vec<U64> entry = Set<U64>(table[static_cast<std::size_t>(i)]);
        for (std::size_t j = 0; j < in_flight; ++j) {
            const Vec<U64> next = hn::Add(product[j], hn::ShiftRightSame(product[j], i));
            const Vec<U64> beyond = greater(next, mantissa[j]);
            product[j] = hn::IfVecThenElse(beyond, product[j], next);
            sum[j] = hn::Add(sum[j], hn::AndNot(beyond, entry));
        }
    }
    return sum;
}

/// numerator / derivative; numerator > 0 or of no matter.
HWY_INLINE Batch divide(const Batch& numerator, const DerivativeBatch& derivative, int scale,
                        int steps)
{
    const auto normalised = [](Vec<U64> a, Vec<U64> length) {
        return hn::ShiftRight<63 - unit_bits>(
            hn::Shl(a, hn::And(hn::Sub(Set<U64>(64), length), Set<U64>(63))));
    };
    Batch rest;
    Batch divisor;
    Batch negative;
    Batch back;
    Batch shift;
    for (std::size_t j = 0; j < in_flight; ++j) {
        const Vec<U64> numerator_bits = bit_length(numerator[j]);
        const Vec<U64> derivative_bits = bit_length(derivative.mantissa[j]);
        rest[j] = normalised(numerator[j], numerator_bits);
        divisor[j] = normalised(derivative.mantissa[j], derivative_bits);
        shift[j] = hn::Add(hn::Sub(numerator_bits, derivative_bits),
                           hn::Add(derivative.fraction_bits[j], Set<U64>(scale - unit_bits)));
        negative[j] = hn::Zero(U64());
        back[j] = hn::Zero(U64());
    }
    std::uint64_t forwards = 0;
    for (int i = 0; i < steps; ++i) {
        const Vec<U64> digit = Set<U64>(unit >> i);
        forwards += unit >> i;
        for (std::size_t j = 0; j < in_flight; ++j) {
            back[j] = hn::Add(back[j], hn::And(negative[j], digit));
            const Vec<U64> next = hn::Sub(rest[j], hn::ShiftRightSame(divisor[j], i));
            const Vec<U64> flipped = sign_of(next);
            rest[j] = hn::Xor(next, flipped);
            negative[j] = hn::Xor(negative[j], flipped);
        }
    }
    Batch result;
    for (std::size_t j = 0; j < in_flight; ++j) {
        const Vec<U64> quotient = hn::Sub(Set<U64>(forwards), hn::Add(back[j], back[j]));
        const Vec<U64> right = sign_of(shift[j]);
        const Vec<U64> vanished = greater(Set<U64>(-unit_bits), shift[j]);
        const Vec<U64> down =
            hn::Shr(quotient, hn::And(hn::Sub(hn::Zero(U64()), shift[j]), Set<U64>(63)));
        Vec<U64> up = hn::Shl(quotient, hn::And(shift[j], Set<U64>(63)));
        if (scale > 0)
            up = hn::IfVecThenElse(greater(shift[j], Set<U64>(3)), Set<U64>(unit << 4), up);
        result[j] = hn::IfVecThenElse(right, hn::AndNot(vanished, down), up);
    }
    return result;
}

/// distance_of() of batches.
HWY_INLINE Batch distance_of(const Batch& r, const DerivativeBatch& dr, const Arithmetic& with)
{
    const Batch l = logarithm(r, with.steps);
    Batch half;
    for (std::size_t j = 0; j < in_flight; ++j)
        half[j] = shifted<unit_bits + 1>(
            multiply(keep(l[j], with.kept_bits), keep(r[j], with.kept_bits)));
    Batch distance = divide(half, dr, with.scale, with.steps);
    for (std::size_t j = 0; j < in_flight; ++j) {
        const Vec<U64> some =
            hn::And(greater(r[j], Set<U64>(unit)),
                    hn::And(greater(l[j], hn::Zero(U64())), greater(half[j], hn::Zero(U64()))));
        distance[j] = hn::And(distance[j], some);
    }
    return distance;
}

} // namespace raymarch::engine::mandelbulb::fast::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
