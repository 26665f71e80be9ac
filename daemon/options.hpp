// SPDX-License-Identifier: MIT
/// @file
/// The command line of raymarchd, made from the table of settings.
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
    std::string config_path; ///< empty: the default path, if it is there
    bool check_config = false;
    std::vector<std::pair<std::string, std::string>> settings; ///< name and text, in table order
};

/// The options, or the status to exit with: help and version were printed, or an error was.
[[nodiscard]] std::variant<Options, int> parse_command_line(int argc, const char* const* argv);

/// Defaults, then the file, then the command line. Errors: Config; for the command line Usage.
[[nodiscard]] Result<Config> load_config(const Options& options);

} // namespace raymarch::daemon
