// SPDX-License-Identifier: MIT
/// @file
/// TABLE: the numbers of the fractal's pipeline (docs/engine/fractal.md, "Numbers").
#pragma once

#include "base/fixed.hpp"
#include "engine/vec3.hpp"

#include <algorithm>
#include <cstdint>

namespace raymarch::engine::fractal
{

/// Every word of the hardware: Q6.16, -32 to below 32; sums wrap, products are floored and wrap.
using Number = Q<6, 16>;
using Point = Vec3<Number>;

[[nodiscard]] constexpr Number word(std::int32_t raw) noexcept
{
    return Number::from_raw(raw);
}

/// All 44 bits of the product, the low 16 dropped, the upper 6 lost.
[[nodiscard]] constexpr Number multiply(Number a, Number b) noexcept
{
    return narrow<Number>(a * b);
}

/// The shift of the hardware: zeros come in at the top, also for negative words.
[[nodiscard]] constexpr Number shift_right(Number a, unsigned bits) noexcept
{
    constexpr std::uint32_t all = (std::uint32_t{1} << Number::width) - 1;
    return Number::from_raw((static_cast<std::uint32_t>(a.raw()) & all) >> bits);
}

/// |-32| does not exist and stays -32.
[[nodiscard]] constexpr Number absolute(Number a) noexcept
{
    return a < Number{} ? -a : a;
}

inline constexpr std::int32_t fraction_mask = (std::int32_t{1} << Number::fraction_bits) - 1;

/// Returns what stands behind the point, 0 to below 1, for negative words too.
[[nodiscard]] constexpr Number fraction(Number a) noexcept
{
    return word(a.raw() & fraction_mask);
}

/// The largest integer that is not above `a`.
[[nodiscard]] constexpr Number floor(Number a) noexcept
{
    return word(a.raw() & ~fraction_mask);
}

/// The middle one of three words.
[[nodiscard]] constexpr Number middle(const Point& p) noexcept
{
    return std::max(std::min(p.x, p.y), std::min(std::max(p.x, p.y), p.z));
}

[[nodiscard]] constexpr Number largest(const Point& p) noexcept
{
    return std::max({p.x, p.y, p.z});
}

inline constexpr Number one = word(1 << 16);
inline constexpr Number half = word(1 << 15);
inline constexpr Number quarter = word(1 << 14);
inline constexpr Number sixteenth = word(1 << 12);
inline constexpr Number three_halves = word(3 << 15);
inline constexpr Number five = word(5 << 16);
// Truncated, as the hardware's are.
inline constexpr Number third = word(21845);
inline constexpr Number tenth = word(6553);
inline constexpr Number hundredth = word(655);

} // namespace raymarch::engine::fractal
