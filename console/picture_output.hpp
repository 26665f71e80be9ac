// SPDX-License-Identifier: MIT
/// @file
/// Where subcommands put a picture: a file, or standard output.
#pragma once

#include "base/result.hpp"
#include "engine/image.hpp"

#include <string>

namespace raymarch::console
{

/// In the format of the name's ending; `-` is PPM on standard output. Errors: those of
/// pictures::format_of and pictures::encode, InputOutput.
[[nodiscard]] Result<void> write_picture(const engine::Image& image, const std::string& path);

} // namespace raymarch::console
