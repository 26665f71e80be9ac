// SPDX-License-Identifier: MIT
/// @file
/// The names that a command line may give, as the tables have them: accelerators, presets, scenes
/// and keys.
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
    std::string_view meaning; ///< empty where the table has none
};
using NamedThings = std::vector<NamedThing>;

[[nodiscard]] NamedThings accelerator_names();
[[nodiscard]] NamedThings preset_names(const protocol::Accelerator& accelerator);
/// Empty when the accelerator has no scenes.
[[nodiscard]] NamedThings scene_names(const protocol::Accelerator& accelerator);
/// Empty when the parameter is a number.
[[nodiscard]] NamedThings choice_names(const protocol::Parameter& parameter);
[[nodiscard]] NamedThings key_names(const protocol::Accelerator& accelerator);

[[nodiscard]] Error has_no_scenes(const protocol::Accelerator& accelerator);
/// Why `name`, said to be a `kind`, is refused: it names what there is, and the nearest of these.
[[nodiscard]] Error unknown_name(std::string_view kind, std::string_view name,
                                 const NamedThings& known);

/// `; did you mean 'NAME'?` of the nearest name; else empty.
[[nodiscard]] std::string meant_instead(std::string_view name, const NamedThings& known);

} // namespace raymarch::cli
