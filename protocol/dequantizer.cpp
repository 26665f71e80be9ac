// SPDX-License-Identifier: MIT
#include "protocol/dequantizer.hpp"

#include "protocol/quantizer.hpp"

#include <charconv>

namespace raymarch::protocol
{
namespace
{

constexpr int max_fraction_digits = 18;

/// magnitude / 2^bits to `digits` decimal places, to the nearest: the integer part, and the
/// fraction as an integer below 10^digits.
struct Rounded
{
    std::uint64_t integer;
    std::uint64_t fraction;
};

Rounded round_to(std::uint64_t magnitude, int bits, int digits) noexcept
{
    const std::uint64_t mask = (std::uint64_t{1} << bits) - 1;
    Rounded result{magnitude >> bits, 0};
    // Long multiplication digit by digit: the rest stays below 2^bits, so 60 bits are enough room.
    std::uint64_t rest = magnitude & mask;
    std::uint64_t power = 1;
    for (int i = 0; i < digits; ++i) {
        rest *= 10;
        result.fraction = result.fraction * 10 + (rest >> bits);
        rest &= mask;
        power *= 10;
    }
    if (bits > 0 && rest >> (bits - 1) != 0)
        ++result.fraction;
    if (result.fraction == power) {
        ++result.integer;
        result.fraction = 0;
    }
    return result;
}

} // namespace

ValueText to_text(const Parameter& parameter, std::int64_t code) noexcept
{
    ValueText text;
    if (parameter.is_choice() && static_cast<std::uint64_t>(code) < parameter.choices.size()) {
        for (const char c : parameter.choices[static_cast<std::size_t>(code)])
            text.append(c);
        return text;
    }

    // Without the hold: a decimal that is only held at the largest code does not name it.
    Parameter unheld = parameter;
    unheld.largest_code = INT64_MAX;
    if (code < parameter.min_scaled || code > parameter.max_scaled) { // no frame can set it
        unheld.positive = {.least = 0, .first_above = UINT64_MAX};
        unheld.negative = unheld.positive;
    }

    const bool negative = code < 0;
    const auto magnitude = negative ? std::uint64_t{0} - static_cast<std::uint64_t>(code)
                                    : static_cast<std::uint64_t>(code);
    for (int digits = 0; digits <= max_fraction_digits; ++digits) {
        const Rounded value = round_to(magnitude, parameter.format.fraction_bits, digits);
        text = ValueText{};
        if (negative)
            text.append('-');
        std::array<char, 20> number{};
        const auto end = std::to_chars(number.data(), number.data() + number.size(), value.integer);
        for (const char* c = number.data(); c != end.ptr; ++c)
            text.append(*c);
        if (digits > 0) {
            text.append('.');
            std::uint64_t fraction = value.fraction;
            for (int i = digits; i-- > 0; fraction /= 10)
                number[static_cast<std::size_t>(i)] = static_cast<char>('0' + fraction % 10);
            for (int i = 0; i < digits; ++i)
                text.append(number[static_cast<std::size_t>(i)]);
        }
        const auto back = quantize(unheld, text.view());
        if (back && *back == code)
            break;
    }
    return text;
}

} // namespace raymarch::protocol
