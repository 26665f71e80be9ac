// SPDX-License-Identifier: MIT
/// @file
/// The subcommands of raymarchctl. Each has its own file.
#pragma once

#include "base/result.hpp"

#include <CLI/CLI.hpp>

#include <functional>

namespace raymarch::cli
{

/// Runs the chosen subcommand and returns the exit status.
using Run = std::function<int()>;

void add_encode(CLI::App& app, Run& run);
void add_decode(CLI::App& app, Run& run);
void add_render(CLI::App& app, Run& run);
void add_film(CLI::App& app, Run& run);
void add_list(CLI::App& app, Run& run);
void add_cycles(CLI::App& app, Run& run);
void add_export(CLI::App& app, Run& run);
void add_receive(CLI::App& app, Run& run);
void add_sheet(CLI::App& app, Run& run);
void add_zoom(CLI::App& app, Run& run);
void add_send(CLI::App& app, Run& run);
void add_console(CLI::App& app, Run& run);
void add_status(CLI::App& app, Run& run);
void add_watch(CLI::App& app, Run& run);
void add_conformance(CLI::App& app, Run& run);
void add_overlay(CLI::App& app, Run& run);

/// The exit status after an ERR reply.
inline constexpr int status_err_reply = 1;

/// Prints the error on standard error and returns its exit status.
int report(const Error& error);

} // namespace raymarch::cli
