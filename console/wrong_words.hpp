// SPDX-License-Identifier: MIT
/// @file
/// What is said of a command line that is not understood.
#pragma once

#include <CLI/CLI.hpp>

#include <string>

namespace raymarch::console
{

/// For CLI::App::failure_message. Of a word that is no subcommand, or no option, it names the
/// nearest one; of any other mistake it says what CLI11 does.
[[nodiscard]] std::string explain(const CLI::App* app, const CLI::Error& error);

} // namespace raymarch::console
