// SPDX-License-Identifier: MIT
/// @file
/// Fixed-point numbers. The type defines their format, rounding and overflow.
///
/// Q<I, F> is two's complement with I integer bits (the sign included) and F fraction bits, as in
/// the sources' "Q8.24"; UQ<I, F> is unsigned. The raw integer is the only state. There are no
/// implicit conversions: a product has the full width of both factors, and only `narrow<To>()`
/// makes a number narrower. It rounds and overflows as `To` says.
#pragma once

#include <compare>
#include <concepts>
#include <cstdint>
#include <limits>
#include <type_traits>

namespace raymarch
{

enum class Sign { Signed, Unsigned };
enum class Rounding {
    Floor,       ///< drops the low bits, as an arithmetic right shift does
    NearestEven, ///< rounds to the nearest code, ties to the even one
};
enum class Overflow {
    Wrap,     ///< keeps the low bits, as a register does
    Saturate, ///< gives the largest or smallest code
};

template <Sign S, int IntegerBits, int FractionBits, Rounding R, Overflow O>
class Fixed
{
  public:
    static constexpr bool is_signed = S == Sign::Signed;
    static constexpr int integer_bits = IntegerBits;
    static constexpr int fraction_bits = FractionBits;
    static constexpr int width = IntegerBits + FractionBits;
    static constexpr Rounding rounding = R;
    static constexpr Overflow overflow = O;
    static_assert(width >= 1 && width <= 64 && FractionBits >= 0);

    using Raw =
        std::conditional_t<is_signed, std::conditional_t<(width > 32), std::int64_t, std::int32_t>,
                           std::conditional_t<(width > 32), std::uint64_t, std::uint32_t>>;

    static constexpr Raw max_raw =
        static_cast<Raw>(std::numeric_limits<Raw>::max() >>
                         (std::numeric_limits<Raw>::digits - (is_signed ? width - 1 : width)));
    static constexpr Raw min_raw = is_signed ? static_cast<Raw>(-max_raw - 1) : Raw{0};

    constexpr Fixed() noexcept = default;

    /// Makes a number from a code that fits. Only the low `width` bits of `raw` are used.
    [[nodiscard]] static constexpr Fixed from_raw(std::integral auto raw) noexcept
    {
        Fixed result;
        result.raw_ = wrap(static_cast<Raw>(raw));
        return result;
    }

    [[nodiscard]] constexpr Raw raw() const noexcept { return raw_; }

    [[nodiscard]] friend constexpr Fixed operator+(Fixed a, Fixed b) noexcept
    {
        Raw raw = 0; // wraps when the storage overflows
        const bool overflowed = __builtin_add_overflow(a.raw_, b.raw_, &raw);
        return settle(raw, a.raw_ < 0, overflowed);
    }
    [[nodiscard]] friend constexpr Fixed operator-(Fixed a, Fixed b) noexcept
    {
        Raw raw = 0;
        const bool overflowed = __builtin_sub_overflow(a.raw_, b.raw_, &raw);
        return settle(raw, is_signed ? a.raw_ < 0 : true, overflowed);
    }
    [[nodiscard]] friend constexpr Fixed operator-(Fixed a) noexcept { return Fixed{} - a; }
    [[nodiscard]] friend constexpr auto operator<=>(Fixed a, Fixed b) noexcept = default;

  private:
    using Unsigned = std::make_unsigned_t<Raw>;

    static constexpr Raw wrap(Raw raw) noexcept
    {
        constexpr int spare = std::numeric_limits<Unsigned>::digits - width;
        return static_cast<Raw>(static_cast<Raw>(static_cast<Unsigned>(raw) << spare) >> spare);
    }
    /// `raw` is the exact result unless the storage itself overflowed.
    static constexpr Fixed settle(Raw raw, bool overflows_downwards,
                                  bool storage_overflowed) noexcept
    {
        if constexpr (O == Overflow::Saturate) {
            if (storage_overflowed)
                return from_raw(overflows_downwards ? min_raw : max_raw);
            return from_raw(raw > max_raw ? max_raw : raw < min_raw ? min_raw : raw);
        }
        return from_raw(raw);
    }

    Raw raw_ = 0;
};

template <int I, int F, Rounding R = Rounding::Floor, Overflow O = Overflow::Wrap>
using Q = Fixed<Sign::Signed, I, F, R, O>;
template <int I, int F, Rounding R = Rounding::Floor, Overflow O = Overflow::Wrap>
using UQ = Fixed<Sign::Unsigned, I, F, R, O>;

/// The exact product is as wide as both factors together. The type checks that it fits 64 bits.
template <Sign S, int I1, int F1, int I2, int F2, Rounding R1, Rounding R2, Overflow O1,
          Overflow O2>
[[nodiscard]] constexpr Fixed<S, I1 + I2, F1 + F2, R1, O1>
operator*(Fixed<S, I1, F1, R1, O1> a, Fixed<S, I2, F2, R2, O2> b) noexcept
{
    using Product = Fixed<S, I1 + I2, F1 + F2, R1, O1>;
    using Wide = typename Product::Raw;
    return Product::from_raw(static_cast<Wide>(a.raw()) * static_cast<Wide>(b.raw()));
}

/// Converts `from` to the format To, with To's rounding and overflow. To has the same signedness,
/// and no more fraction bits than `from`.
template <typename To, Sign S, int I, int F, Rounding R, Overflow O>
[[nodiscard]] constexpr To narrow(Fixed<S, I, F, R, O> from) noexcept
{
    static_assert(To::is_signed == (S == Sign::Signed) && To::fraction_bits <= F);
    constexpr int drop = F - To::fraction_bits;
    auto raw = from.raw();
    if constexpr (drop > 0) {
        using Raw = decltype(raw);
        const Raw floor = static_cast<Raw>(raw >> drop);
        if constexpr (To::rounding == Rounding::NearestEven) {
            const Raw rest = static_cast<Raw>(raw & ((Raw{1} << drop) - 1));
            const Raw half = static_cast<Raw>(Raw{1} << (drop - 1));
            raw = static_cast<Raw>(floor + (rest > half || (rest == half && (floor & 1)) ? 1 : 0));
        } else {
            raw = floor;
        }
    }
    if constexpr (To::overflow == Overflow::Saturate) {
        if (raw > To::max_raw)
            return To::from_raw(To::max_raw);
        if (raw < To::min_raw)
            return To::from_raw(To::min_raw);
    }
    return To::from_raw(raw);
}

} // namespace raymarch
