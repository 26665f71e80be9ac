// SPDX-License-Identifier: MIT
/// @file
/// Reads register words and accelerators on a command line.
#pragma once

#include "base/result.hpp"
#include "protocol/parameters.hpp"
#include "protocol/registers.hpp"

#include <CLI/CLI.hpp>

#include <string>
#include <vector>

namespace raymarch::cli
{

/// Reads all words of the accelerator, such as `01804028` or `0x1804028`. Errors: Usage.
[[nodiscard]] Result<protocol::Words> parse_words(const protocol::Accelerator& accelerator,
                                                  const std::vector<std::string>& texts);

/// Adds `--accelerator NAME`. The value of `name` is the default, or, if it is empty, the default
/// accelerator.
void add_accelerator_option(CLI::App& command, std::string& name, const std::string& meaning);

/// Errors: Usage.
[[nodiscard]] Result<const protocol::Accelerator*> accelerator_named(const std::string& name);

} // namespace raymarch::cli
