// SPDX-License-Identifier: MIT
/// @file
/// Options and arguments that may occur several times and are not changed.
#pragma once

#include <CLI/CLI.hpp>

#include <string>
#include <vector>

namespace raymarch::cli
{

/// Adds an option or a positional argument that takes one or more texts. CLI11 would split `[a,b]`,
/// read `{}` as an empty list and `%%` as the end of a list; here they stay unchanged. An option
/// needs its own `expected` for more than one text. `texts` must live as long as `command`.
CLI::Option* add_texts(CLI::App& command, const std::string& name, std::vector<std::string>& texts,
                       const std::string& meaning);

} // namespace raymarch::cli
