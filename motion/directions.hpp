// SPDX-License-Identifier: MIT
/// @file
/// Turns the directions of WALK and TURN (protocol/commands.hpp) into inputs of a movement.
#pragma once

#include "motion/inputs.hpp"
#include "protocol/commands.hpp"
#include "protocol/text.hpp"

#include <array>
#include <optional>
#include <span>
#include <string_view>

namespace raymarch::motion
{

/// The inputs of WALK, in the order of protocol::walk_directions.
inline constexpr std::array<Input, protocol::walk_directions.size()> walk_inputs = {
    Input::Forward, Input::Back, Input::StrafeLeft, Input::StrafeRight, Input::Up, Input::Down};
/// The inputs of TURN, in the order of protocol::turn_directions.
inline constexpr std::array<Input, protocol::turn_directions.size()> turn_inputs = {
    Input::TurnLeft, Input::TurnRight, Input::TurnUp, Input::TurnDown,
    Input::RollLeft, Input::RollRight, Input::Widen,  Input::Narrow};

namespace detail
{

[[nodiscard]] constexpr std::optional<Input> input_named(std::string_view name,
                                                         std::span<const std::string_view> names,
                                                         std::span<const Input> inputs) noexcept
{
    for (std::size_t i = 0; i < names.size(); ++i)
        if (protocol::equal_ignoring_case(names[i], name))
            return inputs[i];
    return std::nullopt;
}

} // namespace detail

/// The input for a direction of WALK. The case of letters is ignored.
[[nodiscard]] constexpr std::optional<Input> walk_input(std::string_view direction) noexcept
{
    return detail::input_named(direction, protocol::walk_directions, walk_inputs);
}

/// The input for a direction of TURN. The case of letters is ignored.
[[nodiscard]] constexpr std::optional<Input> turn_input(std::string_view direction) noexcept
{
    return detail::input_named(direction, protocol::turn_directions, turn_inputs);
}

} // namespace raymarch::motion
