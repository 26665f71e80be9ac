// SPDX-License-Identifier: MIT
/// @file
/// Makes a type of each row of a table of commands, and reads a command's arguments into it.
///
/// `Command<"WALK">` holds the direction and the steps of a WALK. `AnyCommand<commands>` is the
/// variant of all of them, so that std::visit does not compile while a row has no overload.
#pragma once

#include "protocol/argument_values.hpp"
#include "protocol/commands.hpp"
#include "protocol/errors.hpp"
#include "protocol/text.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <string_view>
#include <tl/expected.hpp>
#include <tuple>
#include <type_traits>
#include <utility>
#include <variant>

namespace raymarch::protocol
{

/// Reads an argument of one kind.
template <ArgumentKind kind>
[[nodiscard]] auto read_argument(const ArgumentRow& row, Text text,
                                 const ReadingContext& context) noexcept
{
    using enum ArgumentKind;
    if constexpr (kind == Assignments)
        return read_pairs(row, text, context);
    else if constexpr (kind == Keys)
        return read_keys(row, text, context);
    else if constexpr (kind == Number)
        return read_number(row, text, context);
    else if constexpr (kind == Zoom)
        return read_zoom(row, text, context);
    else if constexpr (kind == Count)
        return read_count(row, text, context);
    else if constexpr (kind == Choice)
        return read_choice(row, text, context);
    else if constexpr (kind == Group)
        return read_group(row, text, context);
    else if constexpr (kind == Preset)
        return read_preset(row, text, context);
    else if constexpr (kind == ArgumentKind::Accelerator)
        return read_accelerator(row, text, context);
    else {
        static_assert(kind == Topic);
        return Reading<std::string_view>(text.bytes);
    }
}

namespace detail
{

template <const auto& table, std::size_t command, std::size_t argument>
struct ArgumentOf
{
    static constexpr const ArgumentRow& row = table[command].arguments[argument];
    using Always =
        typename std::invoke_result_t<decltype(read_argument<row.kind>), const ArgumentRow&, Text,
                                      const ReadingContext&>::value_type;
    using Value = std::conditional_t<row.optional, std::optional<Always>, Always>;
};

template <const auto& table, std::size_t command, std::size_t... argument>
std::tuple<typename ArgumentOf<table, command, argument>::Value...>
    values_of(std::index_sequence<argument...>);

} // namespace detail

/// A command with the values of its arguments, in the order of its row. An optional one that is
/// missing is empty.
template <const auto& table, std::size_t position>
struct TypedCommand
{
    static constexpr const CommandRow& row = table[position];
    using Arguments = std::make_index_sequence<row.argument_count()>;

    decltype(detail::values_of<table, position>(Arguments())) values;
    std::size_t column = 0; ///< of the first argument
};

namespace detail
{
template <const auto& table, std::size_t... position>
std::variant<TypedCommand<table, position>...> any_of(std::index_sequence<position...>);
} // namespace detail

template <const auto& table>
using AnyCommand = decltype(detail::any_of<table>(std::make_index_sequence<table.size()>()));

/// A name of a command, as an argument of a template.
template <std::size_t size>
struct CommandName
{
    consteval CommandName(const char (&name)[size]) // NOLINT(*-explicit-*,*-avoid-c-arrays)
    {
        std::copy_n(name, size, letters.begin());
    }
    [[nodiscard]] consteval std::string_view text() const { return {letters.data(), size - 1}; }
    std::array<char, size> letters{};
};

/// The type of a command of the service, by its name.
template <CommandName name>
using Command = TypedCommand<commands, position_of(commands, name.text())>;

/// The texts of a command's arguments.
struct ArgumentTexts
{
    std::array<Text, max_arguments> each{};
    std::optional<Text> excess; ///< the text behind the last argument, if there is any
};
[[nodiscard]] ArgumentTexts split_arguments(const CommandRow& row, Text words) noexcept;

/// Finds what is wrong with a command before its arguments are read: an argument is missing, the
/// command takes none, or the accelerator lacks what the command needs.
[[nodiscard]] std::optional<Fault> check_command(const CommandRow& row, Text words,
                                                 const Accelerator& accelerator) noexcept;

/// Finds text after the last argument, or an argument that may not follow the one before it.
[[nodiscard]] std::optional<Fault> check_arguments(const CommandRow& row,
                                                   const ArgumentTexts& texts) noexcept;

/// Reads the arguments of the command at `position` of its table.
template <const auto& table, std::size_t position>
[[nodiscard]] Reading<TypedCommand<table, position>>
read_command(Text words, const ReadingContext& context) noexcept
{
    constexpr const CommandRow& row = table[position];
    if (auto fault = check_command(row, words, context.accelerator))
        return tl::unexpected(*fault);
    const ArgumentTexts texts = split_arguments(row, words);
    TypedCommand<table, position> command{{}, words.column};
    std::optional<Fault> fault;

    const auto read = [&]<std::size_t i>(std::integral_constant<std::size_t, i>) {
        constexpr const ArgumentRow& argument = row.arguments[i];
        if (argument.optional && texts.each[i].empty())
            return true;
        auto value = read_argument<argument.kind>(argument, texts.each[i], context);
        if (value)
            std::get<i>(command.values) = *value;
        else
            fault = value.error();
        return value.has_value();
    };
    // Blank-separated arguments are read from the last to the first: a fault in the number is
    // reported before one in the word.
    constexpr std::size_t count = row.argument_count();
    [&]<std::size_t... i>(std::index_sequence<i...>)
    {
        if constexpr (row.separator == ' ')
            static_cast<void>((read(std::integral_constant<std::size_t, count - 1 - i>()) && ...));
        else
            static_cast<void>((read(std::integral_constant<std::size_t, i>()) && ...));
    }
    (std::make_index_sequence<count>());

    if (!fault)
        fault = check_arguments(row, texts);
    if (fault)
        return tl::unexpected(*fault);
    return command;
}

/// Reads the arguments of the command at `position`, which is less than the table's size, and gives
/// the command or its fault to `take`.
template <const auto& table, class Take>
void read_any_command(std::size_t position, Text words, const ReadingContext& context, Take take)
{
    [&]<std::size_t... i>(std::index_sequence<i...>)
    {
        static_cast<void>(
            ((position == i && (take(read_command<table, i>(words, context)), true)) || ...));
    }
    (std::make_index_sequence<table.size()>());
}

} // namespace raymarch::protocol
