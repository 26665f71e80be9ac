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

} // namespace raymarch::protocol
