// SPDX-License-Identifier: MIT
/// @file
/// distance.hpp, logarithm.hpp and division.hpp in vectors. Compiled once for each instruction set.
#if defined(RAYMARCH_ENGINE_MANDELBULB_FAST_DISTANCE) == defined(HWY_TARGET_TOGGLE)
#ifdef RAYMARCH_ENGINE_MANDELBULB_FAST_DISTANCE
#undef RAYMARCH_ENGINE_MANDELBULB_FAST_DISTANCE
#else
#define RAYMARCH_ENGINE_MANDELBULB_FAST_DISTANCE
#endif

#include "engine/mandelbulb/distance.hpp"
#include "engine/mandelbulb/fast/multiplier-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace raymarch::engine::mandelbulb::HWY_NAMESPACE
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
        const Vec exponent =
            hn::Sub(bit_length<integer_bits>(hn::ShiftRight<unit_bits>(r[j])), all(1));
        mantissa[j] = hn::Shr(r[j], hn::And(exponent, all(63))); // below 1: anything
        product[j] = all(unit);
        sum[j] = multiply_low(all(table[0]), exponent);
    }
    for (int i = 0; i < steps; ++i) {
        const Vec entry = all(table[static_cast<std::size_t>(i)]);
        for (std::size_t j = 0; j < in_flight; ++j) {
            const Vec next = hn::Add(product[j], shift_right(product[j], i));
            const Vec beyond = greater(next, mantissa[j]);
            product[j] = select(beyond, product[j], next);
            sum[j] = hn::Add(sum[j], hn::AndNot(beyond, entry));
        }
    }
    return sum;
}

/// numerator / derivative; numerator > 0 or of no matter.
HWY_INLINE Batch divide(const Batch& numerator, const DerivativeBatch& derivative, int scale,
                        int steps)
{
    const auto normalised = [](Vec a, Vec length) {
        return hn::ShiftRight<63 - unit_bits>(
            hn::Shl(a, hn::And(hn::Sub(all(64), length), all(63))));
    };
    Batch rest;
    Batch divisor;
    Batch negative;
    Batch back;
    Batch shift;
    for (std::size_t j = 0; j < in_flight; ++j) {
        const Vec numerator_bits = bit_length(numerator[j]);
        const Vec derivative_bits = bit_length(derivative.mantissa[j]);
        rest[j] = normalised(numerator[j], numerator_bits);
        divisor[j] = normalised(derivative.mantissa[j], derivative_bits);
        shift[j] = hn::Add(hn::Sub(numerator_bits, derivative_bits),
                           hn::Add(derivative.fraction_bits[j],
                                   all(static_cast<std::uint64_t>(scale - unit_bits))));
        negative[j] = hn::Zero(Words());
        back[j] = hn::Zero(Words());
    }
    std::uint64_t forwards = 0;
    for (int i = 0; i < steps; ++i) {
        const Vec digit = all(unit >> i);
        forwards += unit >> i;
        for (std::size_t j = 0; j < in_flight; ++j) {
            back[j] = hn::Add(back[j], hn::And(negative[j], digit));
            const Vec next = hn::Sub(rest[j], shift_right(divisor[j], i));
            const Vec flipped = sign_of(next);
            rest[j] = hn::Xor(next, flipped);
            negative[j] = hn::Xor(negative[j], flipped);
        }
    }
    Batch result;
    for (std::size_t j = 0; j < in_flight; ++j) {
        const Vec quotient = hn::Sub(all(forwards), hn::Add(back[j], back[j]));
        const Vec right = sign_of(shift[j]);
        const Vec vanished = greater(all(static_cast<std::uint64_t>(-unit_bits)), shift[j]);
        const Vec down = hn::Shr(quotient, hn::And(hn::Sub(hn::Zero(Words()), shift[j]), all(63)));
        Vec up = hn::Shl(quotient, hn::And(shift[j], all(63)));
        if (scale > 0)
            up = select(greater(shift[j], all(3)), all(unit << 4), up);
        result[j] = select(right, hn::AndNot(vanished, down), up);
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
        const Vec some =
            hn::And(greater(r[j], all(unit)),
                    hn::And(greater(l[j], hn::Zero(Words())), greater(half[j], hn::Zero(Words()))));
        distance[j] = hn::And(distance[j], some);
    }
    return distance;
}

} // namespace raymarch::engine::mandelbulb::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
