// SPDX-License-Identifier: MIT
/// @file
/// Reads the name of a tty on a command line: a path, and optionally `@` and a baud rate.
#pragma once

#include "base/result.hpp"

#include <string>
#include <string_view>

namespace raymarch::drivers
{

inline constexpr unsigned default_baud = 115'200;

struct TtyName
{
    std::string path;
    unsigned baud = default_baud;
};

/// Reads `TTY` or `TTY@BAUD`. The baud rate follows the last `@`; an `@` before a `/` belongs to
/// the path. Errors: Usage.
[[nodiscard]] Result<TtyName> parse_tty_name(std::string_view text);

} // namespace raymarch::drivers
