// SPDX-License-Identifier: MIT
/// @file
/// Writes the pictures of subcommands. The output is any that drivers/user_file.hpp accepts.
#pragma once

#include "base/result.hpp"
#include "engine/image.hpp"

#include <CLI/CLI.hpp>

#include <string>

namespace raymarch::cli
{

/// Adds --output, which is required. `path` lives as long as `command`.
void add_picture_output_option(CLI::App& command, std::string& path);

/// Checks the path before the picture is drawn. Errors: those of pictures::format_of and
/// drivers::check_output.
[[nodiscard]] Result<void> check_picture_output(const std::string& path);

/// The ending of the name gives the format; `-` is PPM on standard output. Errors: those of
/// pictures::format_of, pictures::encode and drivers::write_output.
[[nodiscard]] Result<void> write_picture(const engine::Image& image, const std::string& path);

} // namespace raymarch::cli
