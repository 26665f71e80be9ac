// SPDX-License-Identifier: MIT
/// @file
/// Decimal text to the code of a parameter, exactly: checked against the range as written, scaled
/// by 2^f, rounded to the nearest code with ties to even, held at the largest code.
#pragma once

#include "protocol/errors.hpp"
#include "protocol/parameters.hpp"

#include <cstdint>
#include <string_view>
#include <tl/expected.hpp>

namespace raymarch::protocol
{

/// The code of `text` for a number parameter. Errors: Number, Range.
[[nodiscard]] tl::expected<std::int64_t, ErrorCode> quantize(const Parameter& parameter,
                                                             std::string_view text) noexcept;

/// A code of more than 64 bits in two pieces.
struct WideCode
{
    std::int64_t upper = 0; ///< all above the tail, signed
    std::int64_t tail = 0;  ///< the row's tail_bits low bits
    bool operator==(const WideCode&) const = default;
};

/// The same for a parameter with a tail; its range ends inside its format.
[[nodiscard]] tl::expected<WideCode, ErrorCode> quantize_wide(const Parameter& parameter,
                                                              std::string_view text) noexcept;

} // namespace raymarch::protocol
