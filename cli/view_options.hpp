// SPDX-License-Identifier: MIT
/// @file
/// The options of all subcommands that draw a view.
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

/// At most one of line, words, preset and scene is given; otherwise the view has the defaults. The
/// settings change the view, but cannot change words.
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

/// Adds --accelerator, --size and the group "what to draw", and returns the group. The accelerator
/// in `options` is the default. `options` lives as long as `command`.
CLI::Option_group& add_view_options(CLI::App& command, ViewOptions& options);

/// Changes `state` as SET does. Errors: BadData, with the reply that the service would give.
[[nodiscard]] Result<void> change(const protocol::Accelerator& accelerator,
                                  std::string_view settings, protocol::State& state);

// `accelerator` is the one that `options` name. Errors: Usage; BadData, with the reply that the
// service would give to the frame or the changes.

/// With register words, a parameter that they do not hold has its default.
[[nodiscard]] Result<protocol::State> state_of(const protocol::Accelerator& accelerator,
                                               const ViewOptions& options);
[[nodiscard]] Result<protocol::Words> words_of(const protocol::Accelerator& accelerator,
                                               const ViewOptions& options);
[[nodiscard]] Result<protocol::PictureSize> size_of(const protocol::Accelerator& accelerator,
                                                    const ViewOptions& options);

} // namespace raymarch::cli
