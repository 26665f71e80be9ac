// SPDX-License-Identifier: MIT
#include "protocol/quantizer.hpp"

#include "protocol/round_code.hpp"

#include <optional>

namespace raymarch::protocol
{

tl::expected<std::int64_t, ErrorCode> quantize(const Parameter& parameter,
                                               std::string_view text) noexcept
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

tl::expected<WideCode, ErrorCode> quantize_wide(const Parameter& parameter,
                                                std::string_view text) noexcept
{
    const std::optional<Decimal> value = parse_decimal(text);
    if (!value)
        return tl::unexpected(ErrorCode::Number);
    if (compare(*value, *parse_decimal(parameter.min)) < 0 ||
        compare(*value, *parse_decimal(parameter.max)) > 0)
        return tl::unexpected(ErrorCode::Range);

    const WideScaled doubled = scale_wide(*value, parameter.format.fraction_bits + 1);
    std::uint64_t low = doubled.high << 63 | doubled.low >> 1;
    std::uint64_t high = doubled.high >> 1;
    const std::uint64_t inexact = doubled.inexact ? 1 : 0;
    const auto add = [&](std::uint64_t one) {
        low += one;
        high += low < one ? 1 : 0;
    };
    add(doubled.low & (inexact | low) & 1); // to the nearest, ties to even
    if (value->negative) {
        low = ~low;
        high = ~high;
        add(1);
    }
    const int tail = parameter.tail_bits;
    return WideCode{.upper = static_cast<std::int64_t>(high << (64 - tail) | low >> tail),
                    .tail = static_cast<std::int64_t>(low & ((std::uint64_t{1} << tail) - 1))};
}

} // namespace raymarch::protocol
