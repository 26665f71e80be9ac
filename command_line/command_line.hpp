// SPDX-License-Identifier: MIT
/// @file
/// Sets up CLI11 in the same way for raymarchd and raymarchctl.
#pragma once

#include <CLI/CLI.hpp>

namespace raymarch
{

/// Prepares a program's command line, before its options are added. --help keeps a column between
/// an option and its text. An error about a word that is no subcommand, or no option, names the
/// nearest one; an error about another mistake is CLI11's.
void prepare_command_line(CLI::App& app);

} // namespace raymarch
