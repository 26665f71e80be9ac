// SPDX-License-Identifier: MIT
/// @file
/// TABLE: every command that a host may say; parser, HELP, completion and documents read it.
#pragma once

#include "protocol/text.hpp"

#include <array>
#include <cstdint>
#include <string_view>

namespace raymarch::protocol
{

enum class CommandId : std::uint8_t {
    Set,
    View,
    Hue,
    Get,
    Regs,
    Reset,
    Random,
    Status,
    Preset,
    Save,
    Load,
    Accelerator,
    Walk,
    Turn,
    Animate,
    Echo,
    Version,
    Ping,
    Help,
};

/// Whether the command changes the registers. If it does, it is refused while writes are locked.
enum class Effect : std::uint8_t { Reads, Writes };

/// What may follow the command's word.
enum class Arity : std::uint8_t { None, Optional, Required };

struct CommandRow
{
    CommandId id;
    std::string_view name;
    Arity words;
    Effect effect;
    std::string_view arguments; ///< as HELP prints them; GROUP stands for the table's groups
    std::string_view summary;
    Effect bare = Effect::Writes; ///< the effect of a command that writes, if it has no arguments
};

// Laid out by hand: one row a command.
// clang-format off
inline constexpr std::array commands = {
    CommandRow{CommandId::Set,         "SET",         Arity::Required, Effect::Writes, "KEY=VALUE,...",  "changes the named parameters only; all or nothing"},
    CommandRow{CommandId::View,        "VIEW",        Arity::Required, Effect::Writes, "YAW,PITCH,ZOOM", "sets the camera from an orbit: degrees, pitch -89.9 to 89.9, zoom as the parameter"},
    CommandRow{CommandId::Hue,         "HUE",         Arity::Required, Effect::Writes, "H",              "sets the colour from a hue 0 to 1 at full saturation and value"},
    CommandRow{CommandId::Get,         "GET",         Arity::Optional, Effect::Reads,  "[KEY,...]",      "the present values, in the syntax of a frame"},
    CommandRow{CommandId::Regs,        "REGS",        Arity::None,     Effect::Reads,  "",               "the parameter words, in hex"},
    CommandRow{CommandId::Reset,       "RESET",       Arity::Optional, Effect::Writes, "[GROUP]",        "back to the defaults, all or one group"},
    CommandRow{CommandId::Random,      "RANDOM",      Arity::Optional, Effect::Writes, "[GROUP]",        "values drawn inside the ranges, all or one group"},
    CommandRow{CommandId::Status,      "STATUS",      Arity::None,     Effect::Reads,  "",               "state of the service and the hardware, key=value"},
    CommandRow{CommandId::Preset,      "PRESET",      Arity::Optional, Effect::Writes, "[NAME]",         "applies a view worth looking at; without a name lists them", Effect::Reads},
    CommandRow{CommandId::Save,        "SAVE",        Arity::None,     Effect::Reads,  "",               "persists the present values now"},
    CommandRow{CommandId::Load,        "LOAD",        Arity::None,     Effect::Writes, "",               "returns to the values that were persisted"},
    CommandRow{CommandId::Accelerator, "ACCELERATOR", Arity::Optional, Effect::Writes, "[NAME]",         "which accelerator is active; with a name switches, where the block is emulated", Effect::Reads},
    CommandRow{CommandId::Walk,        "WALK",        Arity::Required, Effect::Writes, "DIRECTION [STEPS]", "moves the camera by steps of the accelerator's own"},
    CommandRow{CommandId::Turn,        "TURN",        Arity::Required, Effect::Writes, "DIRECTION [STEPS]", "turns the camera, or its field of view wider or narrower"},
    CommandRow{CommandId::Animate,     "ANIMATE",     Arity::Required, Effect::Writes, "on|off [RATE]",  "lets the scene move by itself, RATE steps a second, 1 to 60"},
    CommandRow{CommandId::Echo,        "ECHO",        Arity::Required, Effect::Reads,  "on|off",         "echoes typed characters with backspace editing, for a person at a terminal"},
    CommandRow{CommandId::Version,     "VERSION",     Arity::None,     Effect::Reads,  "",               "version of the service and of the protocol"},
    CommandRow{CommandId::Ping,        "PING",        Arity::None,     Effect::Reads,  "",               "answers OK"},
    CommandRow{CommandId::Help,        "HELP",        Arity::Optional, Effect::Reads,  "[WORD]",         "explains a command, a parameter or an error code"},
};
// clang-format on

/// What DIRECTION stands for.
inline constexpr std::array<std::string_view, 6> walk_directions = {"forward", "back", "left",
                                                                    "right",   "up",   "down"};
inline constexpr std::array<std::string_view, 8> turn_directions = {
    "left", "right", "up", "down", "roll_left", "roll_right", "wide", "narrow"};

/// Finds the command with this name, in any case of letters; nullptr if there is none.
[[nodiscard]] constexpr const CommandRow* find_command(std::string_view name) noexcept
{
    for (const CommandRow& row : commands)
        if (equal_ignoring_case(row.name, name))
            return &row;
    return nullptr;
}

} // namespace raymarch::protocol
