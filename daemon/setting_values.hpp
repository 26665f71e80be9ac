// SPDX-License-Identifier: MIT
/// @file
/// Declares what only the files of the settings share: the error for a refused value, and the
/// settings whose values say where something is.
#pragma once

#include "daemon/config.hpp"

#include <string_view>

namespace raymarch::daemon
{

/// Makes the error `'TEXT' is not ALLOWED`.
[[nodiscard]] Error refused_value(std::string_view text, std::string_view allowed);

inline constexpr std::string_view registers_values =
    "auto|uio:/dev/uioN|uio-name:NAME|file:PATH|emulated";
inline constexpr std::string_view serial_values = "/dev/TTY[@BAUD]|pty:LINK|none";

// config_places.cpp; to_text() there writes what they read.
[[nodiscard]] Result<void> set_registers(Config& config, std::string_view text);
[[nodiscard]] Result<void> set_serial(Config& config, std::string_view text);

/// Holds the lines of all actions to one another: a line can be requested once. Errors: Config.
[[nodiscard]] Result<void> validate_lines(const Gpio& gpio);

} // namespace raymarch::daemon
