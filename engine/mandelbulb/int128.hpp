// SPDX-License-Identifier: MIT
/// @file
/// 128-bit signed integers where the machine has none: products of two 64-bit words, and the
/// coordinates of the wide form, which have 72 bits.
#pragma once

#include <bit>
#include <compare>
#include <concepts>
#include <cstdint>
#include <type_traits>

namespace raymarch::engine::mandelbulb
{

/// Upper word of the product of two words, from four 32-bit products.
[[nodiscard]] constexpr std::uint64_t high_product(std::uint64_t a, std::uint64_t b) noexcept
{
    constexpr std::uint64_t half = 0xFFFF'FFFF;
    const std::uint64_t low = (a & half) * (b & half);
    const std::uint64_t middle = (a >> 32) * (b & half) + (low >> 32);
    const std::uint64_t other = (a & half) * (b >> 32) + (middle & half);
    return (a >> 32) * (b >> 32) + (middle >> 32) + (other >> 32);
}

/// Two's complement; sums, products and left shifts wrap, right shifts are arithmetic. The names
/// and operators are those of the built-in integers, so that the same code is written once.
class PortableInt128
{
  public:
    constexpr PortableInt128() noexcept = default;
    template <std::integral T>
    constexpr PortableInt128(T value) noexcept // NOLINT(*-explicit-*): as the built-in ones
        : low_(static_cast<std::uint64_t>(value))
    {
        if constexpr (std::is_signed_v<T>)
            high_ = value < 0 ? ~std::uint64_t{0} : 0;
    }

    template <std::integral T>
    [[nodiscard]] explicit constexpr operator T() const noexcept
    {
        return static_cast<T>(low_);
    }

    friend constexpr PortableInt128 operator+(PortableInt128 a, PortableInt128 b) noexcept
    {
        const std::uint64_t low = a.low_ + b.low_;
        return {low, a.high_ + b.high_ + (low < a.low_ ? 1U : 0U)};
    }
    friend constexpr PortableInt128 operator-(PortableInt128 a, PortableInt128 b) noexcept
    {
        return {a.low_ - b.low_, a.high_ - b.high_ - (a.low_ < b.low_ ? 1U : 0U)};
    }
    friend constexpr PortableInt128 operator-(PortableInt128 a) noexcept
    {
        return PortableInt128{} - a;
    }
    friend constexpr PortableInt128 operator*(PortableInt128 a, PortableInt128 b) noexcept
    {
        const std::uint64_t cross = a.high_ * b.low_ + a.low_ * b.high_;
        return {a.low_ * b.low_, high_product(a.low_, b.low_) + cross};
    }
    friend constexpr PortableInt128 operator^(PortableInt128 a, PortableInt128 b) noexcept
    {
        return {a.low_ ^ b.low_, a.high_ ^ b.high_};
    }
    /// Shifts by 0 to 127.
    friend constexpr PortableInt128 operator<<(PortableInt128 a, int by) noexcept
    {
        if (by == 0)
            return a;
        if (by >= 64)
            return {0, a.low_ << (by - 64)};
        return {a.low_ << by, a.high_ << by | a.low_ >> (64 - by)};
    }
    friend constexpr PortableInt128 operator>>(PortableInt128 a, int by) noexcept
    {
        const auto top = static_cast<std::int64_t>(a.high_);
        if (by == 0)
            return a;
        if (by >= 64)
            return {static_cast<std::uint64_t>(top >> (by - 64)),
                    static_cast<std::uint64_t>(top >> 63)};
        return {a.low_ >> by | a.high_ << (64 - by), static_cast<std::uint64_t>(top >> by)};
    }

    constexpr PortableInt128& operator+=(PortableInt128 b) noexcept { return *this = *this + b; }
    constexpr PortableInt128& operator-=(PortableInt128 b) noexcept { return *this = *this - b; }
    constexpr PortableInt128& operator<<=(int by) noexcept { return *this = *this << by; }
    constexpr PortableInt128& operator>>=(int by) noexcept { return *this = *this >> by; }

    friend constexpr bool operator==(PortableInt128 a, PortableInt128 b) noexcept
    {
        return a.low_ == b.low_ && a.high_ == b.high_;
    }
    friend constexpr std::strong_ordering operator<=>(PortableInt128 a, PortableInt128 b) noexcept
    {
        if (a.high_ != b.high_)
            return static_cast<std::int64_t>(a.high_) <=> static_cast<std::int64_t>(b.high_);
        return a.low_ <=> b.low_;
    }

  private:
    constexpr PortableInt128(std::uint64_t low, std::uint64_t high) noexcept
        : low_(low)
        , high_(high)
    {}

    std::uint64_t low_ = 0;
    std::uint64_t high_ = 0;
};

#ifdef __SIZEOF_INT128__                     // 64-bit targets have the instructions
__extension__ typedef __int128 NativeInt128; // NOLINT(modernize-use-using): takes no __extension__
using Int128 = NativeInt128;
#else
using Int128 = PortableInt128;
#endif

/// Index of the leading one bit of a > 0; bit 0 is the last.
[[nodiscard]] constexpr int leading_one(std::uint64_t a) noexcept
{
    return 63 - std::countl_zero(a);
}
[[nodiscard]] constexpr int leading_one(std::int64_t a) noexcept
{
    return leading_one(static_cast<std::uint64_t>(a));
}
template <typename Wide>
[[nodiscard]] constexpr int leading_one(Wide a) noexcept
{
    const auto high = static_cast<std::uint64_t>(a >> 64);
    return high != 0 ? 64 + leading_one(high) : leading_one(static_cast<std::uint64_t>(a));
}

} // namespace raymarch::engine::mandelbulb
