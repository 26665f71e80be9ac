// SPDX-License-Identifier: MIT
/// @file
/// Where the console keeps the lines that were typed.
#pragma once

#include <string>

namespace raymarch::cli
{

/// `$XDG_STATE_HOME/raymarchctl_history`, else `$HOME/.local/state/raymarchctl_history`; empty
/// where there is neither, and where something else than a file has that name. Either may be
/// nullptr; an empty or relative one counts as not set, as the XDG specification wants it.
[[nodiscard]] std::string history_file(const char* state_home, const char* home);

} // namespace raymarch::cli
