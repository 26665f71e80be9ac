// SPDX-License-Identifier: MIT
/// Tries what docs/design.md promises: a new command is one row and one overload.
#include "protocol/typed_command.hpp"
#include "tests/protocol/accelerator.hpp"

#include <gtest/gtest.h>

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <variant>

namespace raymarch::protocol
{
namespace
{

constexpr std::array<std::string_view, 3> lamp_names = {"left", "middle", "right"};

constexpr std::array sample = {
    CommandRow{"NOTHING", Effect::Reads, "does nothing"},
    CommandRow{"BLINK",
               Effect::Writes,
               "blinks a lamp, TIMES {2}",
               {ArgumentRow{.name = "LAMP",
                            .kind = ArgumentKind::Choice,
                            .names = lamp_names,
                            .wrong = "HELP BLINK names the lamps"},
                ArgumentRow{.name = "TIMES",
                            .kind = ArgumentKind::Count,
                            .optional = true,
                            .label = "TIMES",
                            .min = "2",
                            .max = "9"}}},
};

/// The overloads that the row asks for. Without one of them std::visit does not compile.
struct Executor
{
    std::string operator()(const TypedCommand<sample, 0>& /*nothing*/) const { return "nothing"; }
    std::string operator()(const TypedCommand<sample, 1>& blink) const
    {
        const auto [lamp, times] = blink.values;
        return std::string(lamp_names[lamp]) + " " + std::to_string(times.value_or(1));
    }
};

std::string execute(std::string_view name, std::string_view words)
{
    State state = initial_state(accelerator);
    std::optional<AnyCommand<sample>> command;
    Fault fault;
    read_any_command<sample>(position_of(sample, name), {.bytes = words},
                             {accelerator, state, state}, [&](const auto& read) {
                                 if (read)
                                     command = *read;
                                 else
                                     fault = read.error();
                             });
    if (command)
        return std::visit(Executor(), *command);
    const std::string_view why = fault.argument ? fault.argument->label : fault.allowed;
    return "col=" + std::to_string(fault.column) + " " + std::string(why);
}

TEST(OneMoreCommand, IsReadByItsRow)
{
    EXPECT_EQ(execute("NOTHING", ""), "nothing");
    EXPECT_EQ(execute("NOTHING", "x"), "col=1 ");
    EXPECT_EQ(execute("BLINK", "middle"), "middle 1");
    EXPECT_EQ(execute("blink", "RIGHT \t 9"), "right 9");
    EXPECT_EQ(execute("BLINK", "right 1"), "col=7 TIMES");
    EXPECT_EQ(execute("BLINK", "right 10"), "col=7 TIMES");
    EXPECT_EQ(execute("BLINK", "above"), "col=1 HELP BLINK names the lamps");
    EXPECT_EQ(execute("BLINK", ""), "col=1 ");
}

TEST(OneMoreCommand, IsExplainedByItsRow)
{
    std::string text;
    const auto put = [&](std::string_view piece) { text += piece; };
    write_syntax(sample[1], put);
    put(" : ");
    write_summary(sample[1], put);
    EXPECT_EQ(text, "LAMP [TIMES] : blinks a lamp, TIMES 2 to 9");
}

} // namespace
} // namespace raymarch::protocol
