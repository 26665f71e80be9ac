// SPDX-License-Identifier: MIT
/// @file
/// Arguments that may occur several times, taken byte for byte.
#pragma once

#include <CLI/CLI.hpp>

#include <string>
#include <vector>

namespace raymarch::cli
{

/// Adds an option, or a positional argument, that takes one text or more. CLI11 itself makes
/// several texts of `[a,b]`, and reads `{}` and `%%` as an empty list and as an end of one; here
/// they stay what they are. An option needs its own `expected` for more than one text. `texts` must
/// live as long as `command`.
CLI::Option* add_texts(CLI::App& command, const std::string& name, std::vector<std::string>& texts,
                       const std::string& meaning);

} // namespace raymarch::cli
