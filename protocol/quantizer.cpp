// SPDX-License-Identifier: MIT
#include "protocol/quantizer.hpp"

#include <algorithm>
#include <array>
#include <optional>

namespace raymarch::protocol
{
namespace
{

using Quantized = tl::expected<std::int64_t, ErrorCode>;

enum class Fits : std::uint8_t { Yes, No };

/// `doubled` is the magnitude in half codes, with one bit more than the format: enough to see a
/// tie.
inline Fits check_and_round(const Parameter& parameter, bool negative, Scaled doubled,
                            std::int64_t& code) noexcept
{
    const auto above = [&](std::int64_t limit) {
        const std::uint64_t bound = static_cast<std::uint64_t>(limit) * 2;
        return doubled.floor > bound || (doubled.floor == bound && doubled.inexact);
    };
    const bool zero = doubled.floor == 0 && !doubled.inexact;
    if (negative && !zero) {
        if (parameter.min_scaled >= 0 || above(-parameter.min_scaled))
            return Fits::No;
    } else {
        const auto least = static_cast<std::uint64_t>(parameter.min_scaled) * 2;
        if (parameter.max_scaled < 0 || above(parameter.max_scaled) ||
            (parameter.min_scaled > 0 && doubled.floor < least))
            return Fits::No;
    }

    const std::uint64_t half = doubled.floor & 1;
    const std::uint64_t floor = doubled.floor >> 1;
    const bool up = half != 0 && (doubled.inexact || (floor & 1) != 0);
    const auto magnitude = static_cast<std::int64_t>(floor + (up ? 1 : 0));
    code = negative ? -magnitude : std::min(magnitude, parameter.format.max_code());
    return Fits::Yes;
}

constexpr std::array<std::uint64_t, 10> powers_of_ten = {
    1, 10, 100, 1'000, 10'000, 100'000, 1'000'000, 10'000'000, 100'000'000, 1'000'000'000};

/// Digits at the front of `text`, appended to `significand`; how many there were.
inline std::size_t take_digits(std::string_view text, std::uint64_t& significand) noexcept
{
    std::size_t count = 0;
    while (count < text.size() && detail::is_digit(text[count]))
        significand = significand * 10 + static_cast<std::uint64_t>(text[count++] - '0');
    return count;
}

} // namespace

std::size_t quantize_plain(const Parameter& parameter, std::string_view text,
                           std::int64_t& code) noexcept
{
    constexpr std::size_t longest = 18; // 10^18 < 2^64
    const std::string_view front = text.substr(0, longest);
    if (front.empty())
        return 0;
    const bool negative = front[0] == '-';
    std::size_t at = negative || front[0] == '+' ? 1 : 0;

    std::uint64_t significand = 0;
    std::size_t digits = take_digits(front.substr(at), significand);
    at += digits;
    std::size_t fraction_digits = 0;
    if (at < front.size() && front[at] == '.') {
        fraction_digits = take_digits(front.substr(++at), significand);
        at += fraction_digits;
        digits += fraction_digits;
    }
    const unsigned bits = parameter.format.fraction_bits + 1U;
    if (digits == 0 || fraction_digits >= powers_of_ten.size() || bits >= 64 ||
        significand >> (64 - bits) != 0 || (at == longest && text.size() > longest))
        return 0;

    const std::uint64_t shifted = significand << bits;
    const std::uint64_t divisor = powers_of_ten[fraction_digits];
    const std::uint64_t floor = shifted / divisor;
    const Scaled doubled = {.floor = floor, .inexact = floor * divisor != shifted};
    return check_and_round(parameter, negative, doubled, code) == Fits::Yes ? at : 0;
}

Quantized quantize_any_length(const Parameter& parameter, std::string_view text) noexcept
{
    const std::optional<Decimal> value = parse_decimal(text);
    if (!value)
        return tl::unexpected(ErrorCode::Number);
    std::int64_t code = 0;
    const Scaled doubled = scale(*value, parameter.format.fraction_bits + 1);
    if (check_and_round(parameter, value->negative, doubled, code) == Fits::No)
        return tl::unexpected(ErrorCode::Range);
    return code;
}

Quantized quantize(const Parameter& parameter, std::string_view text) noexcept
{
    std::int64_t code = 0;
    if (const std::size_t length = quantize_plain(parameter, text, code);
        length != 0 && length == text.size())
        return code;
    return quantize_any_length(parameter, text);
}

} // namespace raymarch::protocol
