// SPDX-License-Identifier: MIT
#include "engine/whitted/arithmetic.hpp"

#include <bit>

namespace raymarch::engine::whitted
{

Word square_root(std::uint32_t bits) noexcept
{
    // One binary digit a step, two bits of the argument. The unit makes 22 steps; those before the
    // argument's first bit change nothing.
    constexpr std::uint64_t powers_of_two_only = 0xAAAA'AAAA'AAAA'AAAA; // not of four
    std::uint64_t rest = std::uint64_t{bits} << fraction_bits;
    std::uint64_t root = 0;
    std::uint64_t digit = std::bit_floor(rest);
    if ((digit & powers_of_two_only) != 0)
        digit >>= 1;
    for (; digit != 0; digit >>= 2) {
        const std::uint64_t trial = root + digit;
        root >>= 1;
        if (rest >= trial) {
            rest -= trial;
            root += digit;
        }
    }
    return Word::from_raw(static_cast<std::int32_t>(root));
}

Word root_of(Wide squared) noexcept
{
    constexpr std::int64_t word_mask = (1 << Word::width) - 1;
    return square_root(static_cast<std::uint32_t>((squared.raw() >> fraction_bits) & word_mask));
}

Word length(const Vector& v) noexcept
{
    return root_of(dot(v, v));
}

Word divide(Word numerator, Word denominator) noexcept
{
    if (denominator == Word{})
        return {};
    const std::int64_t n = std::int64_t{numerator.raw()} * (1 << fraction_bits);
    const std::int64_t d = denominator.raw();
    std::int64_t quotient = n / d; // towards zero
    if (n % d < 0)
        quotient -= d < 0 ? -1 : 1;
    return Word::from_raw(quotient);
}

Vector normalise(const Vector& v) noexcept
{
    const Word n = length(v);
    return map(v, [=](Word c) { return divide(c, n); });
}

} // namespace raymarch::engine::whitted
