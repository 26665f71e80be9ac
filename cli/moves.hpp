// SPDX-License-Identifier: MIT
/// @file
/// What moves during a film, in words.
#pragma once

#include "base/result.hpp"
#include "motion/inputs.hpp"

#include <string_view>

namespace raymarch::cli
{

/// A list with commas of directions of WALK (`forward`), of TURN with `turn-` before them
/// (`turn-left`), and `animate`; any case. Errors: Usage, naming what there is.
[[nodiscard]] Result<motion::Inputs> parse_moves(std::string_view text);

} // namespace raymarch::cli
