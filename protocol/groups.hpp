// SPDX-License-Identifier: MIT
/// @file
/// The groups of parameters that RESET and RANDOM take.
#pragma once

#include "protocol/parameters.hpp"
#include "protocol/text.hpp"

#include <cstddef>
#include <optional>
#include <string_view>

namespace raymarch::protocol
{

/// Finds a group in any case of letters, and returns it as the table spells it.
[[nodiscard]] constexpr std::optional<std::string_view> find_group(const Accelerator& accelerator,
                                                                   std::string_view name) noexcept
{
    for (const Parameter& parameter : accelerator.parameters)
        if (equal_ignoring_case(parameter.group, name))
            return parameter.group;
    return std::nullopt;
}

/// Whether a parameter belongs to `group`. Every one belongs to the empty group.
[[nodiscard]] constexpr bool is_in_group(const Parameter& parameter,
                                         std::string_view group) noexcept
{
    return group.empty() || parameter.group == group;
}

/// Sets the parameters of `group` to their defaults.
constexpr void reset(const Accelerator& accelerator, std::string_view group, State& state) noexcept
{
    for (std::size_t i = 0; i < accelerator.parameters.size(); ++i)
        if (is_in_group(accelerator.parameters[i], group))
            state.codes[i] = accelerator.parameters[i].initial_code;
}

} // namespace raymarch::protocol
