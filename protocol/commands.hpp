// SPDX-License-Identifier: MIT
/// @file
/// TABLE: every command that a host may say. Its row is all that parser, HELP, completion and
/// documents know of it.
///
/// Each row has its own type, `Command<"NAME">` (protocol/typed_command.hpp). The controller has
/// one overload of run() for each type.
#pragma once

#include "protocol/text.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

namespace raymarch::protocol
{

/// Whether the command changes the registers. If it does, it is refused while writes are locked.
enum class Effect : std::uint8_t { Reads, Writes };

/// What an argument is, and so the type of its value (protocol/argument_values.hpp).
enum class ArgumentKind : std::uint8_t {
    None,
    Assignments, ///< KEY=VALUE,… to the end of the line
    Keys,        ///< KEY,… to the end of the line, each once
    Number,      ///< a decimal number within bounds
    Zoom,        ///< a value of the zoom of the camera
    Count,       ///< a whole number within bounds
    Choice,      ///< one of the row's names
    Group,       ///< a group of parameters
    Preset,      ///< a preset of the accelerator, to the end of the line
    Accelerator, ///< the name of an accelerator, to the end of the line
    Topic,       ///< any text to the end of the line
};

/// One argument of a command.
struct ArgumentRow
{
    std::string_view name{}; ///< as HELP prints it; empty for a choice whose names are printed
    ArgumentKind kind = ArgumentKind::None;
    bool optional = false;
    std::string_view label{}; ///< the name in the reply to a number outside the bounds
    std::string_view min{};   ///< decimal text, inclusive: the bounds of a Number or a Count
    std::string_view max{};
    std::string_view unit{};
    std::span<const std::string_view> names{}; ///< of a Choice
    std::string_view wrong{};                  ///< the reply to a value that is not allowed
    std::string_view
        only_after{}; ///< the only choice that it may follow; empty if it may follow any
    std::string_view misplaced{}; ///< the reply if it follows another choice
};

/// What an accelerator must have for a command.
enum class Needs : std::uint8_t { Nothing, OrbitCamera, Colour };

/// The largest number of arguments of a command.
inline constexpr std::size_t max_arguments = 3;

struct CommandRow
{
    std::string_view name;
    Effect effect;
    /// `{1}` stands for the bounds of the first argument, and so on.
    std::string_view summary;
    std::array<ArgumentRow, max_arguments> arguments{};
    char separator = ' ';      ///< between arguments: a blank or a comma
    std::string_view excess{}; ///< the reply to more arguments than there are
    Needs needs = Needs::Nothing;
    Effect effect_without_arguments = effect;

    [[nodiscard]] constexpr std::size_t argument_count() const noexcept
    {
        std::size_t count = 0;
        while (count < max_arguments && arguments[count].kind != ArgumentKind::None)
            ++count;
        return count;
    }
    [[nodiscard]] constexpr bool needs_argument() const noexcept
    {
        return argument_count() > 0 && !arguments[0].optional;
    }
};

inline constexpr std::array<std::string_view, 2> on_or_off = {"on", "off"};
inline constexpr std::array<std::string_view, 6> walk_directions = {"forward", "back", "left",
                                                                    "right",   "up",   "down"};
inline constexpr std::array<std::string_view, 8> turn_directions = {
    "left", "right", "up", "down", "roll_left", "roll_right", "wide", "narrow"};

// Laid out by hand: one row an argument, one row a command.
// clang-format off
namespace arguments
{
using enum ArgumentKind;

inline constexpr ArgumentRow pairs       = {.name = "KEY=VALUE,...", .kind = Assignments};
inline constexpr ArgumentRow keys        = {.name = "KEY,...", .kind = Keys, .optional = true, .wrong = "GET takes the keys of parameters, each once"};
inline constexpr ArgumentRow yaw         = {.name = "YAW", .kind = Number, .label = "yaw", .min = "-1000000", .max = "1000000", .unit = "degrees"};
inline constexpr ArgumentRow pitch       = {.name = "PITCH", .kind = Number, .label = "pitch", .min = "-89.9", .max = "89.9", .unit = "degrees"};
inline constexpr ArgumentRow zoom        = {.name = "ZOOM", .kind = Zoom};
inline constexpr ArgumentRow hue         = {.name = "H", .kind = Number, .label = "hue", .min = "0", .max = "1"};
inline constexpr ArgumentRow group       = {.name = "GROUP", .kind = Group, .optional = true, .wrong = "HELP RESET names the groups"};
inline constexpr ArgumentRow preset      = {.name = "NAME", .kind = Preset, .optional = true, .wrong = "PRESET alone lists the presets"};
inline constexpr ArgumentRow accelerator = {.name = "NAME", .kind = Accelerator, .optional = true, .wrong = "HELP ACCELERATOR names the accelerators"};
inline constexpr ArgumentRow walk        = {.name = "DIRECTION", .kind = Choice, .names = walk_directions, .wrong = "HELP WALK names the directions"};
inline constexpr ArgumentRow turn        = {.name = "DIRECTION", .kind = Choice, .names = turn_directions, .wrong = "HELP TURN names the directions"};
inline constexpr ArgumentRow steps       = {.name = "STEPS", .kind = Count, .optional = true, .label = "STEPS", .min = "1", .max = "1000"};
inline constexpr ArgumentRow animate     = {.kind = Choice, .names = on_or_off, .wrong = "ANIMATE takes on or off"};
inline constexpr ArgumentRow rate        = {.name = "RATE", .kind = Count, .optional = true, .label = "RATE", .min = "1", .max = "60", .only_after = "on", .misplaced = "ANIMATE off takes no rate"};
inline constexpr ArgumentRow echo        = {.kind = Choice, .names = on_or_off, .wrong = "ECHO takes on or off"};
inline constexpr ArgumentRow topic       = {.name = "WORD", .kind = Topic, .optional = true};
} // namespace arguments

inline constexpr std::array commands = {
    CommandRow{"SET",         Effect::Writes, "changes the named parameters only; all or nothing", {arguments::pairs}},
    CommandRow{"VIEW",        Effect::Writes, "sets the camera from an orbit: degrees, pitch {2}, zoom as the parameter", {arguments::yaw, arguments::pitch, arguments::zoom}, ',', "VIEW takes three numbers: yaw,pitch,zoom", Needs::OrbitCamera},
    CommandRow{"HUE",         Effect::Writes, "sets the colour from a hue {1} at full saturation and value", {arguments::hue}, ',', "HUE takes one number", Needs::Colour},
    CommandRow{"GET",         Effect::Reads,  "the present values, in the syntax of a frame", {arguments::keys}},
    CommandRow{"REGS",        Effect::Reads,  "the parameter words, in hex"},
    CommandRow{"RESET",       Effect::Writes, "back to the defaults, all or one group", {arguments::group}, ' ', "one group, or none for all"},
    CommandRow{"RANDOM",      Effect::Writes, "values drawn inside the ranges, all or one group", {arguments::group}, ' ', "one group, or none for all"},
    CommandRow{"STATUS",      Effect::Reads,  "state of the service and the hardware, key=value"},
    CommandRow{"PRESET",      Effect::Writes, "applies a view worth looking at; without a name lists them", {arguments::preset}, ' ', {}, Needs::Nothing, Effect::Reads},
    CommandRow{"SAVE",        Effect::Reads,  "persists the present values now"},
    CommandRow{"LOAD",        Effect::Writes, "returns to the values that were persisted"},
    CommandRow{"ACCELERATOR", Effect::Writes, "which accelerator is active; with a name switches, where the block is emulated", {arguments::accelerator}, ' ', {}, Needs::Nothing, Effect::Reads},
    CommandRow{"WALK",        Effect::Writes, "moves the camera by steps of the accelerator's own", {arguments::walk, arguments::steps}},
    CommandRow{"TURN",        Effect::Writes, "turns the camera, or its field of view wider or narrower", {arguments::turn, arguments::steps}},
    CommandRow{"ANIMATE",     Effect::Writes, "lets the scene move by itself, RATE steps a second, {2}", {arguments::animate, arguments::rate}},
    CommandRow{"ECHO",        Effect::Reads,  "echoes typed characters with backspace editing, for a person at a terminal", {arguments::echo}, ' ', "ECHO takes on or off"},
    CommandRow{"VERSION",     Effect::Reads,  "version of the service and of the protocol"},
    CommandRow{"PING",        Effect::Reads,  "answers OK"},
    CommandRow{"HELP",        Effect::Reads,  "explains a command, a parameter or an error code", {arguments::topic}},
};
// clang-format on

namespace detail
{
consteval unsigned whole_number(std::string_view digits)
{
    unsigned value = 0;
    for (const char c : digits)
        value = value * 10 + static_cast<unsigned>(c - '0');
    return value;
}
} // namespace detail

/// WALK and TURN take at most most_steps steps. ANIMATE makes at most most_rate steps a second, and
/// usual_rate where no RATE is given.
inline constexpr unsigned most_steps = detail::whole_number(arguments::steps.max);
inline constexpr unsigned most_rate = detail::whole_number(arguments::rate.max);
inline constexpr unsigned usual_rate = 20;

/// The position of a command in its table, by its name in any case of letters; the table's size if
/// there is none.
[[nodiscard]] constexpr std::size_t position_of(std::span<const CommandRow> table,
                                                std::string_view name) noexcept
{
    std::size_t i = 0;
    while (i < table.size() && !equal_ignoring_case(table[i].name, name))
        ++i;
    return i;
}

/// Finds the command with this name, in any case of letters; nullptr if there is none.
[[nodiscard]] constexpr const CommandRow* find_command(std::string_view name) noexcept
{
    const std::size_t i = position_of(commands, name);
    return i < commands.size() ? &commands[i] : nullptr;
}

/// Gives `put` the bounds of a number, piece by piece: "-89.9 to 89.9".
template <class Put>
constexpr void write_bounds(const ArgumentRow& argument, Put put)
{
    put(argument.min);
    put(std::string_view(" to "));
    put(argument.max);
}

/// Gives `put` the arguments of a command as HELP prints them, piece by piece: "on|off [RATE]".
template <class Put>
constexpr void write_syntax(const CommandRow& row, Put put)
{
    for (std::size_t i = 0; i < row.argument_count(); ++i) {
        const ArgumentRow& argument = row.arguments[i];
        if (i > 0)
            put(std::string_view(&row.separator, 1));
        put(std::string_view(argument.optional ? "[" : ""));
        if (argument.name.empty())
            for (std::size_t name = 0; name < argument.names.size(); ++name) {
                put(std::string_view(name == 0 ? "" : "|"));
                put(argument.names[name]);
            }
        put(argument.name);
        put(std::string_view(argument.optional ? "]" : ""));
    }
}

/// Gives `put` the summary of a command, piece by piece.
template <class Put>
constexpr void write_summary(const CommandRow& row, Put put)
{
    std::string_view rest = row.summary;
    for (std::size_t open = 0; (open = rest.find('{')) != std::string_view::npos;) {
        put(rest.substr(0, open));
        write_bounds(row.arguments[static_cast<std::size_t>(rest[open + 1] - '1')], put);
        rest.remove_prefix(open + 3);
    }
    put(rest);
}

} // namespace raymarch::protocol
