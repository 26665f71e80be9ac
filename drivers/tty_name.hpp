// SPDX-License-Identifier: MIT
/// @file
/// The name of a tty as a person writes it: a path, and a baud rate behind an `@`.
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

/// Reads `TTY` or `TTY@BAUD`. The baud rate stands behind the last `@`; an `@` with a `/` somewhere
/// behind it belongs to the path. Errors: Usage, which names what is wrong and what is allowed.
[[nodiscard]] Result<TtyName> parse_tty_name(std::string_view text);

} // namespace raymarch::drivers
