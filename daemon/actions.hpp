// SPDX-License-Identifier: MIT
/// @file
/// TABLE: what buttons and switches do and what LEDs show. The keys of the configuration, their
/// errors, the documents and the panel are made from it.
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

/// What an LED may show, as it is at one moment.
struct Glance
{
    std::chrono::milliseconds uptime{};
    bool accepted = false; ///< blinks with each frame that is taken
    bool refused = false;  ///< the last frame was
    Health hardware;
    std::array<bool, 3> colour{}; ///< red, green, blue
};

enum class ActionKind : std::uint8_t { Button, Switch, Led };
[[nodiscard]] std::string_view name_of(ActionKind kind) noexcept;

/// Called when a level that counts comes.
using Press = void (*)(Controller& controller);
/// Called with each change, and with the level that is found at the start.
using Follow = void (*)(Controller& controller, bool on);
/// Called while the level is on: at once, then so many times a second.
struct Repeat
{
    unsigned Gpio::*rate;
    Press step;
};
/// Whether the LED is lit.
using Show = bool (*)(const Glance& glance) noexcept;

struct Action
{
    std::string_view name; ///< its key in the configuration
    ActionKind kind;
    std::string_view line;  ///< the default, as the configuration writes it
    std::string_view place; ///< what that is on a PYNQ-Z1
    std::string_view meaning;
    std::variant<Press, Follow, Repeat, Show> behaviour; ///< Show for an LED, and only there
};
[[nodiscard]] std::span<const Action> actions() noexcept;

} // namespace raymarch::daemon
