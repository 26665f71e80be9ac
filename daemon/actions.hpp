// SPDX-License-Identifier: MIT
/// @file
/// TABLE: the actions of buttons, switches and LEDs. The configuration keys, their errors and the
/// documents are made from it.
#pragma once

#include "daemon/config.hpp"
#include "daemon/controller.hpp"

#include <array>
#include <chrono>
#include <cstdint>
#include <span>
#include <string_view>
#include <variant>

namespace raymarch::daemon
{

/// The state that LEDs can show.
struct PanelStatus
{
    std::chrono::milliseconds uptime{};
    bool accepted = false; ///< blinks with each accepted frame
    bool refused = false;  ///< the last frame was refused
    Health hardware;
    std::array<bool, 3> colour{}; ///< red, green, blue
};

enum class ActionKind : std::uint8_t { Button, Switch, Led };
[[nodiscard]] std::string_view name_of(ActionKind kind) noexcept;

/// Called when a button is pressed.
using Press = void (*)(Controller& controller);
/// Called with the level at the start and with each change.
using Follow = void (*)(Controller& controller, bool on);
/// `step` is called at once and then `rate` times a second while the level is on.
struct Repeat
{
    unsigned Gpio::*rate;
    Press step;
};
/// Returns whether the LED is lit.
using Show = bool (*)(const PanelStatus& status) noexcept;

struct Action
{
    std::string_view name; ///< its key in the configuration
    ActionKind kind;
    std::string_view line;  ///< the default line in the configuration
    std::string_view place; ///< the label of that line on a PYNQ-Z1
    std::string_view meaning;
    std::variant<Press, Follow, Repeat, Show> behaviour; ///< Show if and only if it is an LED
};
[[nodiscard]] std::span<const Action> actions() noexcept;

} // namespace raymarch::daemon
