// SPDX-License-Identifier: MIT
/// @file
/// Register words and accelerators as a command line names them.
#pragma once

#include "base/result.hpp"
#include "protocol/parameters.hpp"
#include "protocol/registers.hpp"

#include <CLI/CLI.hpp>

#include <string>
#include <vector>

namespace raymarch::cli
{

/// `01804028` or `0x1804028`, as many as the accelerator has. Errors: Usage.
[[nodiscard]] Result<protocol::Words> parse_words(const protocol::Accelerator& accelerator,
                                                  const std::vector<std::string>& texts);

/// Adds `--accelerator NAME`, which goes to `name`. What is in `name`
/// is the default; where nothing is, the default accelerator.
void add_accelerator_option(CLI::App& command, std::string& name, const std::string& meaning);

/// By name. Errors: Usage, naming what there is.
[[nodiscard]] Result<const protocol::Accelerator*> accelerator_named(const std::string& name);

} // namespace raymarch::cli
