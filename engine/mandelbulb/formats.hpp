// SPDX-License-Identifier: MIT
/// @file
/// The two forms of a coordinate, each with the products that the stages need. The stages are
/// written once, as templates over one of these.
#pragma once

#include "engine/mandelbulb/int128.hpp"
#include "engine/vec3.hpp"

#include <cstdint>

namespace raymarch::engine::mandelbulb
{

/// Basis and rays: Q1.57.
inline constexpr int direction_bits = 57;
using Direction = Vec3<std::int64_t>;

/// Q8.57, 65 bits in the source (§IV.F). No value reaches 64, so 64 bits give the same.
/// `Wide` is an integer of 128 bits.
template <typename Wide>
struct Q57
{
    using Coordinate = std::int64_t;
    using WideInteger = Wide;
    static constexpr int fraction_bits = 57;

    /// (v * gain) >> 63.
    [[nodiscard]] static constexpr Coordinate scaled(Coordinate v, std::int64_t gain) noexcept
    {
        return static_cast<Coordinate>((Wide(v) * Wide(gain)) >> 63);
    }
    /// (a * b) >> 57; a, b >= 0.
    [[nodiscard]] static constexpr Coordinate product(Coordinate a, Coordinate b) noexcept
    {
        return static_cast<Coordinate>((Wide(a) * Wide(b)) >> fraction_bits);
    }
    /// (a * b) >> 58: the whole product may need one bit more than a coordinate has.
    [[nodiscard]] static constexpr Coordinate half_product(Coordinate a, Coordinate b) noexcept
    {
        return static_cast<Coordinate>((Wide(a) * Wide(b)) >> (fraction_bits + 1));
    }
    /// (a * b) >> 57 with a derivative; a >= 0.
    [[nodiscard]] static constexpr Wide product(Coordinate a, std::uint64_t b) noexcept
    {
        return (Wide(a) * Wide(b)) >> fraction_bits;
    }
};

/// Q8.64: 72 bits. Products of 128 bits and more are put together from words.
template <typename Wide>
struct Q64
{
    using Coordinate = Wide;
    using WideInteger = Wide;
    static constexpr int fraction_bits = 64;

    [[nodiscard]] static constexpr Coordinate scaled(Coordinate v, std::int64_t gain) noexcept
    {
        return ((v >> 64) * Wide(gain) << 1) + ((low(v) * Wide(gain)) >> 63);
    }
    [[nodiscard]] static constexpr Coordinate product(Coordinate a, Coordinate b) noexcept
    {
        return (a >> 64) * b + low(a) * (b >> 64) +
               Wide(high_product(static_cast<std::uint64_t>(a), static_cast<std::uint64_t>(b)));
    }
    [[nodiscard]] static constexpr Coordinate half_product(Coordinate a, Coordinate b) noexcept
    {
        return product(a, b) >> 1;
    }
    [[nodiscard]] static constexpr Wide product(Coordinate a, std::uint64_t b) noexcept
    {
        return (a >> 64) * Wide(b) + Wide(high_product(static_cast<std::uint64_t>(a), b));
    }

  private:
    [[nodiscard]] static constexpr Wide low(Coordinate v) noexcept
    {
        return Wide(static_cast<std::uint64_t>(v));
    }
};

/// 2^exponent.
template <typename Format>
[[nodiscard]] constexpr typename Format::Coordinate power_of_two(int exponent) noexcept
{
    return typename Format::Coordinate(1) << exponent;
}

template <typename Format>
using Point = Vec3<typename Format::Coordinate>;

} // namespace raymarch::engine::mandelbulb
