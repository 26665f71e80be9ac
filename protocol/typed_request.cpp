// SPDX-License-Identifier: MIT
#include "protocol/typed_request.hpp"

#include "protocol/assignments.hpp"
#include "protocol/request.hpp"

namespace raymarch::protocol
{
namespace
{

void parse_frame(Text text, const ReadingContext& context, TypedRequest& parsed)
{
    parsed.effect = Effect::Writes;
    context.result = context.present;
    if (const auto fault = read_frame(context.accelerator, text, context.result))
        parsed.what.emplace<Fault>(*fault);
    else
        parsed.what.emplace<Frame>(Frame{&context.result});
}

void parse_command(const CommandRow& row, Text words, const ReadingContext& context,
                   TypedRequest& parsed)
{
    parsed.effect = words.empty() ? row.effect_without_arguments : row.effect;
    const auto take = [&](const auto& command) {
        if (command)
            parsed.what.emplace<AnyCommand<commands>>(*command);
        else
            parsed.what.emplace<Fault>(command.error());
    };
    read_any_command<commands>(static_cast<std::size_t>(&row - commands.data()), words, context,
                               take);
}

} // namespace

TypedRequest parse(const Line& line, const ReadingContext& context, bool require_checksum)
{
    const Request request = read_request(line, require_checksum);
    TypedRequest parsed{.checksummed = request.checksummed, .what = Silence::Blank};
    switch (request.kind) {
    case Request::Kind::Blank:
        break;
    case Request::Kind::Reply:
        parsed.what.emplace<Silence>(Silence::Reply);
        break;
    case Request::Kind::Faulty:
        parsed.what.emplace<Fault>(request.fault);
        break;
    case Request::Kind::Frame:
        parse_frame(request.text, context, parsed);
        break;
    case Request::Kind::Command:
        parse_command(*request.command, request.text, context, parsed);
        break;
    }
    return parsed;
}

} // namespace raymarch::protocol
