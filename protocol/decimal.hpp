// SPDX-License-Identifier: MIT
/// @file
/// A number exactly as it was written, and its exact value in units of a power of two.
///
/// Nothing here is rounded through floating point: a decimal keeps every digit, and `scale` gives
/// the integer part and says whether anything was left over.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>

namespace raymarch::protocol
{

/// The longest number that a line may hold, sign and exponent included.
inline constexpr std::size_t max_number_length = 32;

/// The value is ±0.d1d2…dn * 10^point, without leading or trailing zeros; zero has no digits.
struct Decimal
{
    bool negative = false;
    std::uint8_t count = 0;
    std::int16_t point = 0;
    std::array<std::uint8_t, max_number_length> digits{};
};

/// Reads `[+-]? ( digits [ . digits* ] | . digits ) ( [eE] [+-]? digits{1,3} )?`, at most 32
/// characters; nothing for any other text.
[[nodiscard]] constexpr std::optional<Decimal> parse_decimal(std::string_view text) noexcept;

/// Negative, zero or positive as `a` is below, equal to or above `b`; exact.
[[nodiscard]] constexpr int compare(const Decimal& a, const Decimal& b) noexcept;

/// |value| * 2^bits = `floor` + a rest below 1; `inexact` when the rest is not zero.
/// `floor` stands at its largest value, and `inexact` is set, when it needs more than 64 bits.
struct Scaled
{
    std::uint64_t floor = 0;
    bool inexact = false;
};

/// Scales by 2^bits, bits 0 to 65.
[[nodiscard]] constexpr Scaled scale(const Decimal& value, int bits) noexcept;

/// The same with a floor of 128 bits.
struct WideScaled
{
    std::uint64_t high = 0;
    std::uint64_t low = 0;
    bool inexact = false;
};
[[nodiscard]] constexpr WideScaled scale_wide(const Decimal& value, int bits) noexcept;

// ------------------------------------------------------------------------------------------------

namespace detail
{

[[nodiscard]] constexpr bool is_digit(char c) noexcept
{
    return c >= '0' && c <= '9';
}

/// `[eE] [+-]? digits{1,3}`, all of it.
[[nodiscard]] constexpr std::optional<int> parse_exponent(std::string_view text) noexcept
{
    if (text[0] != 'e' && text[0] != 'E')
        return std::nullopt;
    text.remove_prefix(1);
    const bool negative = text.starts_with('-');
    if (negative || text.starts_with('+'))
        text.remove_prefix(1);
    if (text.empty() || text.size() > 3)
        return std::nullopt;
    int exponent = 0;
    for (const char c : text) {
        if (!is_digit(c))
            return std::nullopt;
        exponent = exponent * 10 + (c - '0');
    }
    return negative ? -exponent : exponent;
}

/// An unsigned integer wide enough for 32 digits shifted by 65 bits: 107 + 65 bits.
/// 32-bit limbs, least significant first, so that a 32-bit core needs nothing wider than 64 bits.
class Wide
{
  public:
    constexpr void multiply_add(std::uint32_t factor, std::uint32_t addend) noexcept
    {
        std::uint64_t carry = addend;
        for (std::uint32_t& limb : limbs_) {
            carry += std::uint64_t{limb} * factor;
            limb = static_cast<std::uint32_t>(carry);
            carry >>= 32;
        }
    }

    /// Divides in place and returns the remainder.
    constexpr std::uint32_t divide(std::uint32_t divisor) noexcept
    {
        std::uint64_t rest = 0;
        for (std::size_t i = limbs_.size(); i-- > 0;) {
            rest = (rest << 32) | limbs_[i];
            limbs_[i] = static_cast<std::uint32_t>(rest / divisor);
            rest %= divisor;
        }
        return static_cast<std::uint32_t>(rest);
    }

    /// Divides by 2^64.
    constexpr void drop_piece() noexcept
    {
        for (std::size_t i = 0; i < limbs_.size(); ++i)
            limbs_[i] = i + 2 < limbs_.size() ? limbs_[i + 2] : 0;
    }
    /// Whether all from 64-bit piece `piece` on is zero.
    [[nodiscard]] constexpr bool ends_below(std::size_t piece) const noexcept
    {
        for (std::size_t i = 2 * piece; i < limbs_.size(); ++i)
            if (limbs_[i] != 0)
                return false;
        return true;
    }
    /// Bits 64 * piece and up.
    [[nodiscard]] constexpr std::uint64_t piece(std::size_t piece) const noexcept
    {
        return std::uint64_t{limbs_[2 * piece + 1]} << 32 | limbs_[2 * piece];
    }

  private:
    std::array<std::uint32_t, 6> limbs_{};
};

} // namespace detail

constexpr std::optional<Decimal> parse_decimal(std::string_view text) noexcept
{
    using detail::is_digit;
    if (text.empty() || text.size() > max_number_length)
        return std::nullopt;

    Decimal value;
    std::size_t at = 0;
    if (text[0] == '+' || text[0] == '-') {
        value.negative = text[0] == '-';
        at = 1;
    }

    bool any_digit = false;
    bool after_point = false;
    int point = 0;
    for (; at < text.size(); ++at) {
        const char c = text[at];
        if (c == '.' && !after_point) {
            after_point = true;
            continue;
        }
        if (!is_digit(c))
            break;
        any_digit = true;
        if (c != '0' || value.count > 0)
            value.digits[value.count++] = static_cast<std::uint8_t>(c - '0');
        if (!after_point && value.count > 0)
            ++point;
        if (after_point && value.count == 0)
            --point;
    }
    if (!any_digit)
        return std::nullopt;

    if (at < text.size()) {
        const std::optional<int> exponent = detail::parse_exponent(text.substr(at));
        if (!exponent)
            return std::nullopt;
        point += *exponent;
    }

    while (value.count > 0 && value.digits[value.count - 1U] == 0)
        value.digits[--value.count] = 0;
    if (value.count == 0) // every zero is the same zero
        return Decimal{};
    value.point = static_cast<std::int16_t>(point);
    return value;
}

constexpr int compare(const Decimal& a, const Decimal& b) noexcept
{
    if (a.count == 0 || b.count == 0 || a.negative != b.negative) {
        const int sign_a = a.count == 0 ? 0 : a.negative ? -1 : 1;
        const int sign_b = b.count == 0 ? 0 : b.negative ? -1 : 1;
        return sign_a - sign_b;
    }
    const int larger = a.negative ? -1 : 1;
    if (a.point != b.point)
        return a.point > b.point ? larger : -larger;
    for (std::size_t i = 0; i < a.digits.size(); ++i) // unused digits are zero
        if (a.digits[i] != b.digits[i])
            return a.digits[i] > b.digits[i] ? larger : -larger;
    return 0;
}

constexpr WideScaled scale_wide(const Decimal& value, int bits) noexcept
{
    constexpr WideScaled too_large = {.high = UINT64_MAX, .low = UINT64_MAX, .inexact = true};
    if (value.count == 0)
        return {};
    if (value.point > 20) // at least 10^20, and so above 2^64: no format reaches that far
        return too_large;
    if (value.point < -20) // below 10^-20, and so below 2^-65
        return {.inexact = true};

    detail::Wide wide;
    for (std::size_t i = 0; i < value.count; ++i)
        wide.multiply_add(10, value.digits[i]);
    int exponent = value.point - value.count;
    for (; exponent > 0; --exponent)
        wide.multiply_add(10, 0);
    for (; bits > 0; bits -= bits < 16 ? bits : 16)
        wide.multiply_add(std::uint32_t{1} << (bits < 16 ? bits : 16), 0);

    bool inexact = false;
    for (; exponent < 0; exponent += 9) {
        std::uint32_t divisor = 1;
        for (int i = 0; i < 9 && i < -exponent; ++i)
            divisor *= 10;
        inexact |= wide.divide(divisor) != 0;
    }
    if (!wide.ends_below(2))
        return too_large;
    return {.high = wide.piece(1), .low = wide.piece(0), .inexact = inexact};
}

constexpr Scaled scale(const Decimal& value, int bits) noexcept
{
    const WideScaled wide = scale_wide(value, bits);
    if (wide.high != 0)
        return {.floor = UINT64_MAX, .inexact = true};
    return {.floor = wide.low, .inexact = wide.inexact};
}

} // namespace raymarch::protocol
