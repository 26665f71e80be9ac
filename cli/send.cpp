// SPDX-License-Identifier: MIT
/// @file
/// `raymarchctl send`: sends lines to the service and prints the replies.
#include "cli/connection.hpp"
#include "cli/subcommands.hpp"
#include "cli/texts.hpp"

#include <fmt/format.h>
#include <sysexits.h>

#include <memory>
#include <string>
#include <vector>

namespace raymarch::cli
{
namespace
{

struct SendOptions
{
    Endpoint endpoint;
    std::vector<std::string> lines;
};

int send(const SendOptions& options)
{
    for (const std::string& line : options.lines)
        if (line.find('\n') != std::string::npos)
            return report(plain_error(ErrorKind::Usage, "each argument must be one line"));
    auto connection = Connection::open(options.endpoint);
    if (!connection)
        return report(connection.error());
    bool refused = false;
    for (const std::string& line : options.lines) {
        if (replies_due(line) == 0)
            continue;
        const auto reply = ask_and_print(*connection, line);
        if (!reply)
            return report(*connection, reply.error());
        refused |= is_err(*reply);
    }
    return refused ? status_err_reply : EX_OK;
}

} // namespace

void add_send(CLI::App& app, Run& run)
{
    CLI::App* const command = app.add_subcommand(
        "send", "sends lines and prints the replies; the exit status is 0 if all of them are OK");
    const auto options = std::make_shared<SendOptions>();
    add_endpoint_options(*command, options->endpoint);
    add_texts(*command, "LINE", options->lines, "frames and commands to send, each as one argument")
        ->required();
    command->callback([options, &run] { run = [options] { return send(*options); }; });
}

} // namespace raymarch::cli
