// SPDX-License-Identifier: MIT
/// @file
/// Parses --move of `raymarchctl film`.
#pragma once

#include "base/result.hpp"
#include "motion/inputs.hpp"

#include <string_view>

namespace raymarch::cli
{

/// Reads a comma-separated list of directions of WALK (`forward`), directions of TURN with a prefix
/// (`turn-left`), and `animate`. The case is ignored. Errors: Usage.
[[nodiscard]] Result<motion::Inputs> parse_moves(std::string_view text);

} // namespace raymarch::cli
