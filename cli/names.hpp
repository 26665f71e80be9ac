// SPDX-License-Identifier: MIT
/// @file
/// The names of accelerators, presets, scenes and keys, from the tables.
#pragma once

#include "base/result.hpp"
#include "protocol/parameters.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace raymarch::cli
{

struct NamedThing
{
    std::string_view name;
    std::string_view meaning; ///< empty if the table has none
};
using NamedThings = std::vector<NamedThing>;

[[nodiscard]] NamedThings accelerator_names();
[[nodiscard]] NamedThings preset_names(const protocol::Accelerator& accelerator);
/// Returns an empty list if the accelerator has no scenes.
[[nodiscard]] NamedThings scene_names(const protocol::Accelerator& accelerator);
/// Returns an empty list if the parameter is a number.
[[nodiscard]] NamedThings choice_names(const protocol::Parameter& parameter);
[[nodiscard]] NamedThings key_names(const protocol::Accelerator& accelerator);

[[nodiscard]] Error has_no_scenes(const protocol::Accelerator& accelerator);
/// Makes the error for an unknown `name` of a `kind`, with all known names and a suggestion.
[[nodiscard]] Error unknown_name(std::string_view kind, std::string_view name,
                                 const NamedThings& known);

/// Returns `; did you mean 'NAME'?`, or an empty string if no name is near.
[[nodiscard]] std::string suggestion(std::string_view name, const NamedThings& known);

} // namespace raymarch::cli
