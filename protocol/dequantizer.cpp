// SPDX-License-Identifier: MIT
#include "protocol/dequantizer.hpp"

#include "protocol/quantizer.hpp"

#include <charconv>

namespace raymarch::protocol
{
namespace
{

/// 10^-20 is below half a unit of the finest format, 2^-65.
constexpr int max_fraction_digits = 20;
constexpr std::size_t room = max_number_length;

/// A magnitude with 64 integer bits and 64 fraction bits.
struct Magnitude
{
    std::uint64_t integer;
    std::uint64_t fraction;
};

Magnitude magnitude_of(const Parameter& parameter, WideCode code) noexcept
{
    const bool negative = code.upper < 0;
    const int tail = parameter.tail_bits;
    const int bits = parameter.code_fraction_bits();
    auto upper = static_cast<std::uint64_t>(code.upper);
    auto low = static_cast<std::uint64_t>(code.tail);
    if (negative) { // this negates both halves as one two's complement number
        upper = ~upper + (low == 0 ? 1 : 0);
        low = low == 0 ? 0 : (std::uint64_t{1} << tail) - low;
    }
    if (bits == 0)
        return {upper, 0};
    return {bits == 64 ? 0 : upper >> bits, upper << (64 - bits) | (tail == 0 ? 0 : low)};
}

/// Decimal digits. The least significant digit is first.
struct Digits
{
    std::array<char, room> text{};
    std::size_t count = 0;
    bool carry = false; ///< true if the fraction was rounded up to 1
};

/// Rounds `fraction` / 2^64 to the nearest number with `count` decimal places.
Digits round_to(std::uint64_t fraction, int count) noexcept
{
    detail::Wide scaled;
    for (int piece = 3; piece >= 0; --piece)
        scaled.multiply_add(1U << 16,
                            static_cast<std::uint32_t>(fraction >> (16 * piece)) & 0xFFFF);
    for (int i = 0; i < count; ++i)
        scaled.multiply_add(10, 0);
    const bool up = scaled.piece(0) >> 63 != 0;
    scaled.drop_piece();
    scaled.multiply_add(1, up ? 1 : 0);
    Digits digits;
    for (; digits.count < static_cast<std::size_t>(count); ++digits.count)
        digits.text[digits.count] = static_cast<char>('0' + scaled.divide(10));
    digits.carry = scaled.piece(0) != 0;
    return digits;
}

bool quantises_back(const Parameter& parameter, std::string_view text, WideCode code) noexcept
{
    if (parameter.tail_bits > 0) {
        const auto back = quantize_wide(parameter, text);
        return back && *back == code;
    }
    // There is no clamping here: a decimal that is merely clamped to the largest code does not
    // name it.
    Parameter unheld = parameter;
    unheld.largest_code = INT64_MAX;
    if (code.upper < parameter.min_scaled || code.upper > parameter.max_scaled) {
        // No frame can set this code.
        unheld.positive = {.least = 0, .first_above = UINT64_MAX};
        unheld.negative = unheld.positive;
    }
    const auto back = quantize(unheld, text);
    return back && *back == code.upper;
}

} // namespace

ValueText to_text(const Parameter& parameter, std::int64_t code, std::int64_t tail) noexcept
{
    ValueText text;
    if (parameter.is_choice() && static_cast<std::uint64_t>(code) < parameter.choices.size()) {
        for (const char c : parameter.choices[static_cast<std::size_t>(code)])
            text.append(c);
        return text;
    }

    const Magnitude magnitude = magnitude_of(parameter, {.upper = code, .tail = tail});
    for (int count = 0; count <= max_fraction_digits; ++count) {
        const Digits digits = round_to(magnitude.fraction, count);
        text = ValueText{};
        if (code < 0)
            text.append('-');
        std::array<char, 20> number{};
        const auto end = std::to_chars(number.data(), number.data() + number.size(),
                                       magnitude.integer + (digits.carry ? 1 : 0));
        for (const char* c = number.data(); c != end.ptr; ++c)
            text.append(*c);
        if (count > 0)
            text.append('.');
        for (std::size_t i = digits.count; i-- > 0;)
            text.append(digits.text[i]);
        if (quantises_back(parameter, text.view(), {.upper = code, .tail = tail}))
            break;
    }
    return text;
}

} // namespace raymarch::protocol
