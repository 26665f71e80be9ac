// SPDX-License-Identifier: MIT
/// @file
/// TABLE: the numbers of the pipeline (docs/engine/whitted.md, "Numbers"): 24-bit words and their
/// 48-bit products, all of which wrap.
#pragma once

#include "base/fixed.hpp"
#include "engine/vec3.hpp"

#include <array>
#include <cstdint>

namespace raymarch::engine::whitted
{

/// Positions, distances, directions: 1.0 = 4096.
using Word = Q<12, 12>;
/// A product of two words, a sum of such products: squared lengths among them.
using Wide = Q<24, 24>;
using Vector = Vec3<Word>;

/// Red, green, blue inside a ray: 0 to 1023 in 12 bits; a colour of a table is a multiple of 32.
using Colour = std::array<std::uint16_t, 3>;
/// A fraction of 4096: how much of a ray's light reaches the eye, how much a surface reflects.
using Weight = std::uint16_t;

inline constexpr int fraction_bits = Word::fraction_bits;
inline constexpr Weight full_weight = 4095;
inline constexpr Weight least_weight = 40;         ///< below 1 % nothing is reflected any more
inline constexpr std::uint16_t brightest = 1023;   ///< of a channel
inline constexpr int screen_shift = 5;             ///< the set-up divides scene distances by 32
inline constexpr int light_shift = 4;              ///< the way to the light is divided by 16
inline constexpr int least_plane_distance = 0x400; ///< raw: nearer planes are not met

/// ax*bx + ay*by + az*bz; nothing is shifted before the sum.
[[nodiscard]] constexpr Wide dot(const Vector& a, const Vector& b) noexcept
{
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

/// An arithmetic shift of the word's bits.
[[nodiscard]] constexpr Word shift_right(Word a, int bits) noexcept
{
    return Word::from_raw(a.raw() >> bits);
}

/// v * factor per axis, floored.
[[nodiscard]] constexpr Vector scale(const Vector& v, Word factor) noexcept
{
    return map(v, [=](Word c) { return narrow<Word>(c * factor); });
}

} // namespace raymarch::engine::whitted
