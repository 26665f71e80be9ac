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
    reply << "# " << row.name;
    if (!row.arguments.empty())
        reply << ' ' << row.arguments;
    reply << " : " << row.summary;
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

void write_directions(ReplyWriter& reply, std::span<const std::string_view> directions) noexcept
{
    reply << "# DIRECTION is";
    for (const std::string_view direction : directions)
        reply << ' ' << direction;
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
        if (row->arguments.find("GROUP") != std::string_view::npos)
            write_groups(reply, accelerator);
        if (row->id == CommandId::Walk)
            write_directions(reply, walk_directions);
        if (row->id == CommandId::Turn)
            write_directions(reply, turn_directions);
        if (row->id == CommandId::Accelerator)
            write_accelerators(reply);
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
