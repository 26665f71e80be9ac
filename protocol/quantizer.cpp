// SPDX-License-Identifier: MIT
#include "protocol/quantizer.hpp"

#include <array>
#include <optional>

namespace raymarch::protocol
{
namespace
{

using Quantized = tl::expected<std::int64_t, ErrorCode>;

/// `doubled` is the value in half codes, with one bit more than the format: enough to see a tie.
Quantized check_and_round(const Parameter& parameter, bool negative, Scaled doubled) noexcept
{
    const auto above = [&](std::int64_t limit) {
        const std::uint64_t bound = static_cast<std::uint64_t>(limit) * 2;
        return doubled.floor > bound || (doubled.floor == bound && doubled.inexact);
    };
    const bool zero = doubled.floor == 0 && !doubled.inexact;
    if (negative && !zero) {
        if (parameter.min_scaled >= 0 || above(-parameter.min_scaled))
            return tl::unexpected(ErrorCode::Range);
    } else {
        const auto least = static_cast<std::uint64_t>(parameter.min_scaled) * 2;
        if (parameter.max_scaled < 0 || above(parameter.max_scaled) ||
            (parameter.min_scaled > 0 && doubled.floor < least))
            return tl::unexpected(ErrorCode::Range);
    }

    const std::uint64_t half = doubled.floor & 1;
    const std::uint64_t floor = doubled.floor >> 1;
    const bool up = half != 0 && (doubled.inexact || (floor & 1) != 0);
    const auto magnitude = static_cast<std::int64_t>(floor + (up ? 1 : 0));
    if (negative)
        return -magnitude;
    return magnitude > parameter.format.max_code() ? parameter.format.max_code() : magnitude;
}

constexpr std::array<std::uint64_t, 10> powers_of_ten = {
    1, 10, 100, 1'000, 10'000, 100'000, 1'000'000, 10'000'000, 100'000'000, 1'000'000'000};

/// A number without an exponent that fits 64-bit arithmetic; most numbers of most hosts.
struct Short
{
    bool negative;
    std::uint64_t significand;
    unsigned fraction_digits;
};

std::optional<Short> parse_short(std::string_view text) noexcept
{
    constexpr std::size_t longest = 18; // 10^18 < 2^64
    if (text.empty() || text.size() > longest)
        return std::nullopt;
    Short value{.negative = text[0] == '-', .significand = 0, .fraction_digits = 0};
    std::size_t at = text[0] == '-' || text[0] == '+' ? 1 : 0;

    const std::size_t integer_begin = at;
    for (; at < text.size() && detail::is_digit(text[at]); ++at)
        value.significand = value.significand * 10 + static_cast<std::uint64_t>(text[at] - '0');
    std::size_t digits = at - integer_begin;

    if (at < text.size() && text[at] == '.') {
        const std::size_t fraction_begin = ++at;
        for (; at < text.size() && detail::is_digit(text[at]); ++at)
            value.significand = value.significand * 10 + static_cast<std::uint64_t>(text[at] - '0');
        value.fraction_digits = static_cast<unsigned>(at - fraction_begin);
        digits += value.fraction_digits;
    }
    if (at != text.size() || digits == 0 || value.fraction_digits >= powers_of_ten.size())
        return std::nullopt;
    return value;
}

} // namespace

Quantized quantize_any_length(const Parameter& parameter, std::string_view text) noexcept
{
    const std::optional<Decimal> value = parse_decimal(text);
    if (!value)
        return tl::unexpected(ErrorCode::Number);
    return check_and_round(parameter, value->negative,
                           scale(*value, parameter.format.fraction_bits + 1));
}

Quantized quantize(const Parameter& parameter, std::string_view text) noexcept
{
    const std::optional<Short> value = parse_short(text);
    const unsigned bits = parameter.format.fraction_bits + 1U;
    if (!value || bits >= 64 || value->significand >> (64 - bits) != 0)
        return quantize_any_length(parameter, text);

    const std::uint64_t shifted = value->significand << bits;
    const std::uint64_t divisor = powers_of_ten[value->fraction_digits];
    return check_and_round(parameter, value->negative,
                           {.floor = shifted / divisor, .inexact = shifted % divisor != 0});
}

} // namespace raymarch::protocol
