// SPDX-License-Identifier: MIT
/// @file
/// The file in which the console keeps its history.
#pragma once

#include <string>

namespace raymarch::cli
{

/// Returns `$XDG_STATE_HOME/raymarchctl_history`, else `$HOME/.local/state/raymarchctl_history`.
/// The result is empty if neither variable is set, or if the path is not an ordinary file. A
/// variable that is nullptr, empty or relative counts as not set (XDG specification).
[[nodiscard]] std::string history_file(const char* state_home, const char* home);

} // namespace raymarch::cli
