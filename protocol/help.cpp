// SPDX-License-Identifier: MIT
#include "protocol/help.hpp"

#include "protocol/accelerators.hpp"
#include "protocol/commands.hpp"
#include "protocol/dequantizer.hpp"
#include "protocol/errors.hpp"

#include <algorithm>

namespace raymarch::protocol
{
namespace
{

void write_command(ReplyWriter& reply, const CommandRow& row) noexcept
{
    const auto put = [&](std::string_view text) { reply << text; };
    reply << "# " << row.name;
    if (row.argument_count() > 0)
        reply << ' ';
    write_syntax(row, put);
    reply << " : ";
    write_summary(row, put);
    reply.end_line();
}

/// Collects the groups of the table, each once, in table order.
void write_groups(ReplyWriter& reply, const Accelerator& accelerator) noexcept
{
    reply << "# GROUP is";
    const auto parameters = accelerator.parameters;
    for (std::size_t i = 0; i < parameters.size(); ++i) {
        const auto before = parameters.first(i);
        if (std::ranges::find(before, parameters[i].group, &Parameter::group) == before.end())
            reply << ' ' << parameters[i].group;
    }
    reply.end_line();
}

void write_names(ReplyWriter& reply, const ArgumentRow& argument) noexcept
{
    reply << "# " << argument.name << " is";
    for (const std::string_view name : argument.names)
        reply << ' ' << name;
    reply.end_line();
}

void write_accelerators(ReplyWriter& reply) noexcept
{
    for (const Accelerator* accelerator : accelerators) {
        reply << "# " << accelerator->name << " : " << accelerator->summary;
        reply.end_line();
    }
}

void write_parameter(ReplyWriter& reply, const Parameter& parameter) noexcept
{
    reply << "# " << parameter.key << " : " << parameter.meaning << "; ";
    write_allowed(reply, parameter);
    reply << "; default " << parameter.initial;
    reply.end_line();
}

void write_everything(ReplyWriter& reply, const Accelerator& accelerator) noexcept
{
    reply << "# A frame is KEY=VALUE,... with all of";
    write_keys(reply, accelerator);
    reply << "; any other line is a command:";
    reply.end_line();
    for (const CommandRow& row : commands)
        write_command(reply, row);
    write_groups(reply, accelerator);
    reply << "# HELP with a command, a key or an error code tells more of it";
    reply.end_line();
}

} // namespace

bool write_help(ReplyWriter& reply, const Accelerator& accelerator, std::string_view word) noexcept
{
    if (word.empty()) {
        write_everything(reply, accelerator);
        return true;
    }
    if (const CommandRow* row = find_command(word)) {
        write_command(reply, *row);
        for (const ArgumentRow& argument : row->arguments) {
            if (argument.kind == ArgumentKind::Group)
                write_groups(reply, accelerator);
            if (argument.kind == ArgumentKind::Choice && !argument.name.empty())
                write_names(reply, argument);
            if (argument.kind == ArgumentKind::Accelerator)
                write_accelerators(reply);
        }
        return true;
    }
    if (const auto index = find_parameter(accelerator, word)) {
        write_parameter(reply, accelerator.parameters[*index]);
        return true;
    }
    for (const ErrorRow& row : errors) {
        if (equal_ignoring_case(row.name, word)) {
            reply << "# " << row.name << " : " << row.meaning;
            reply.end_line();
            return true;
        }
    }
    return false;
}

} // namespace raymarch::protocol
