// SPDX-License-Identifier: MIT
/// @file
/// `raymarchctl send`: lines to the service, replies to standard output.
#include "console/connection.hpp"
#include "console/subcommands.hpp"

#include <fmt/format.h>
#include <sysexits.h>

#include <memory>
#include <string>
#include <vector>

namespace raymarch::console
{
namespace
{

struct Options
{
    Endpoint endpoint;
    std::vector<std::string> lines;
};

/// A line that is blank has no reply to wait for.
bool has_reply(const std::string& line)
{
    return line.find_first_not_of(" \t\r") != std::string::npos;
}

int send(const Options& options)
{
    auto connection = Connection::open(options.endpoint);
    if (!connection)
        return report(connection.error());
    bool refused = false;
    for (const std::string& line : options.lines) {
        if (line.find('\n') != std::string::npos)
            return report(plain_error(ErrorKind::Usage, "one line an argument"));
        if (!has_reply(line))
            continue;
        const auto reply = ask_and_print(*connection, line);
        if (!reply)
            return report(reply.error());
        refused |= is_err(*reply);
    }
    return refused ? status_err_reply : EX_OK;
}

} // namespace

void add_send(CLI::App& app, Run& run)
{
    CLI::App* const command =
        app.add_subcommand("send", "sends lines and prints the replies; 0 if all are OK");
    const auto options = std::make_shared<Options>();
    add_endpoint_options(*command, options->endpoint);
    command->add_option("LINE", options->lines, "frames and commands, one an argument")->required();
    command->callback([options, &run] { run = [options] { return send(*options); }; });
}

} // namespace raymarch::console
