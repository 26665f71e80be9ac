// SPDX-License-Identifier: MIT
/// @file
/// What is looked at: the options that every subcommand with a picture of its own has.
#pragma once

#include "base/result.hpp"
#include "protocol/accelerators.hpp"
#include "protocol/parameters.hpp"
#include "protocol/registers.hpp"

#include <CLI/CLI.hpp>

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace raymarch::cli
{

/// At most one of line, words, preset and scene is given; none: the defaults. Settings change what
/// is given, but for words.
struct ViewOptions
{
    std::string accelerator{protocol::default_accelerator.name};
    std::optional<std::string> line;
    std::vector<std::string> words;
    std::optional<std::string> settings;
    std::optional<std::string> preset;
    std::optional<std::string> scene;
    std::optional<std::string> size;
};

/// --accelerator, --size, and the group "what to draw", which it returns. The accelerator that
/// `options` name now is the default. `options` lives as long as `command`.
CLI::Option_group& add_view_options(CLI::App& command, ViewOptions& options);

/// Changes `state` as SET does. Errors: BadData with the reply of the service.
[[nodiscard]] Result<void> change(const protocol::Accelerator& accelerator,
                                  std::string_view settings, protocol::State& state);

// Of the accelerator that `options` name, see accelerator_named. Errors: Usage; BadData with the
// reply of the service to a bad frame or bad changes.

/// What registers do not hold is at its default where register words are given.
[[nodiscard]] Result<protocol::State> state_of(const protocol::Accelerator& accelerator,
                                               const ViewOptions& options);
[[nodiscard]] Result<protocol::Words> words_of(const protocol::Accelerator& accelerator,
                                               const ViewOptions& options);
[[nodiscard]] Result<protocol::PictureSize> size_of(const protocol::Accelerator& accelerator,
                                                    const ViewOptions& options);

} // namespace raymarch::cli
