// SPDX-License-Identifier: MIT
/// @file
/// Where subcommands put a picture: what drivers/user_file.hpp takes for an output.
#pragma once

#include "base/result.hpp"
#include "engine/image.hpp"

#include <CLI/CLI.hpp>

#include <string>

namespace raymarch::cli
{

/// Adds --output, which is required. `path` lives as long as `command`.
void add_picture_output_option(CLI::App& command, std::string& path);

/// To be called before the work, not after it. Errors: those of pictures::format_of and
/// drivers::check_output.
[[nodiscard]] Result<void> check_picture_output(const std::string& path);

/// In the format of the name's ending; `-` is PPM on standard output. Errors: those of
/// pictures::format_of, pictures::encode and drivers::write_output.
[[nodiscard]] Result<void> write_picture(const engine::Image& image, const std::string& path);

} // namespace raymarch::cli
