// SPDX-License-Identifier: MIT
/// @file
/// Decimal text to the code of a parameter, exactly: checked against the range as written, scaled
/// by 2^f, rounded to the nearest code with ties to even, held at the largest code.
#pragma once

#include "protocol/errors.hpp"
#include "protocol/parameters.hpp"

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <tl/expected.hpp>

namespace raymarch::protocol
{

/// The code of `text` for a number parameter. Errors: Number, Range.
[[nodiscard]] tl::expected<std::int64_t, ErrorCode> quantize(const Parameter& parameter,
                                                             std::string_view text) noexcept;

/// The code of a plain number at the front of `text`: at most 18 characters, no exponent, in range.
/// Returns how many characters it has, or 0 for any other text, faulty or not: that is for
/// `quantize` to tell apart. What most numbers of most hosts take, in 64-bit arithmetic.
[[nodiscard]] std::size_t quantize_plain(const Parameter& parameter, std::string_view text,
                                         std::int64_t& code) noexcept;

/// The same as `quantize` by the general way alone; the tests hold the two together.
[[nodiscard]] tl::expected<std::int64_t, ErrorCode>
quantize_any_length(const Parameter& parameter, std::string_view text) noexcept;

} // namespace raymarch::protocol
