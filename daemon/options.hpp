// SPDX-License-Identifier: MIT
/// @file
/// Reads the command line of raymarchd. Its options come from the table of settings.
#pragma once

#include "daemon/config.hpp"

#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace raymarch::daemon
{

struct Options
{
    std::string config_path; ///< empty means the default path, if the file exists
    bool check_config = false;
    std::vector<std::pair<std::string, std::string>> settings; ///< name and text, in table order
};

/// Returns the options, or the exit status after it has printed a help text or an error.
[[nodiscard]] std::variant<Options, int> parse_command_line(int argc, const char* const* argv);

/// Takes the defaults, then the file, then the command line. Errors: Config, or Usage for the
/// command line.
[[nodiscard]] Result<Config> load_config(const Options& options);

} // namespace raymarch::daemon
