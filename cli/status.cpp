// SPDX-License-Identifier: MIT
/// @file
/// `raymarchctl status` and `watch`: print the state of the service, once or when it changes.
#include "protocol/status.hpp"

#include "cli/connection.hpp"
#include "cli/subcommands.hpp"

#include <fmt/chrono.h>
#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <poll.h>
#include <sysexits.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <ctime>
#include <memory>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace raymarch::cli
{
namespace
{

using Fields = std::vector<std::pair<std::string, std::string>>;

/// Splits `OK key=value key=value` or `OK KEY=VALUE,KEY=VALUE` into pairs.
Fields fields_of(std::string reply)
{
    for (char& c : reply)
        if (c == ',')
            c = ' ';
    std::istringstream words(reply);
    std::string word;
    Fields fields;
    while (words >> word)
        if (const std::size_t equals = word.find('='); equals != std::string::npos)
            fields.emplace_back(word.substr(0, equals), word.substr(equals + 1));
    return fields;
}

/// Errors: InputOutput, also for an ERR or a reply without fields.
Result<Fields> ask_fields(Connection& connection, const char* command)
{
    const auto reply = connection.request(command);
    if (!reply)
        return fail(reply.error());
    Fields fields;
    if (!is_err(*reply))
        fields = fields_of(*reply);
    if (fields.empty())
        return fail(plain_error(ErrorKind::InputOutput,
                                fmt::format("the reply to {} is '{}'", command, visible(*reply))));
    return fields;
}

/// A value is a number where the row of its key says so and it can be read as one, else a string.
nlohmann::json json_of(const Fields& fields)
{
    nlohmann::json object = nlohmann::json::object();
    for (const auto& [key, value] : fields) {
        const protocol::StatusRow* const row = protocol::find_status_row(key);
        nlohmann::json number;
        if (row != nullptr && row->kind == protocol::StatusKind::Number)
            number = nlohmann::json::parse(value, nullptr, false);
        object[key] = number.is_number() ? std::move(number) : nlohmann::json(value);
    }
    return object;
}

struct StatusOptions
{
    Endpoint endpoint;
    bool json = false;
};

int status(const StatusOptions& options)
{
    auto connection = Connection::open(options.endpoint);
    if (!connection)
        return report(connection.error());
    const auto fields = ask_fields(*connection, "STATUS");
    if (!fields)
        return report(*connection, fields.error());
    if (options.json) {
        fmt::print("{}\n", json_of(*fields).dump(2));
        return EX_OK;
    }
    for (const auto& [key, value] : *fields)
        fmt::print("{:<24} {}\n", key, value);
    return EX_OK;
}

struct WatchOptions
{
    Endpoint endpoint;
    double seconds = 1.0;
    unsigned count = 0;
};

/// These fields change all the time, so their changes are not printed.
bool always_changes(std::string_view key)
{
    using protocol::StatusKey;
    return key == status_row(StatusKey::Uptime).name || key == status_row(StatusKey::Fps).name;
}

std::string changes(const Fields& before, const Fields& now)
{
    std::string text;
    for (const auto& field : now)
        if (!always_changes(field.first) &&
            std::find(before.begin(), before.end(), field) == before.end())
            text += fmt::format(" {}={}", field.first, field.second);
    return text;
}

/// Waits. Returns false if the reader closed standard output, or if a signal came.
bool pause_for(double seconds, Connection& connection)
{
    std::array<pollfd, 2> waiting = {
        pollfd{.fd = STDOUT_FILENO,
               .events = 0,
               .revents = 0}, // poll() always reports an error of a pipe
        pollfd{.fd = connection.stop_fd(), .events = POLLIN, .revents = 0},
    };
    return ::poll(waiting.data(), waiting.size(), static_cast<int>(seconds * 1000)) <= 0;
}

/// Errors: InputOutput.
Result<Fields> poll_service(Connection& connection)
{
    auto fields = ask_fields(connection, "STATUS");
    if (!fields)
        return fields;
    auto parameters = ask_fields(connection, "GET");
    if (!parameters)
        return parameters;
    fields->insert(fields->end(), parameters->begin(), parameters->end());
    return fields;
}

int watch(const WatchOptions& options)
{
    auto connection = Connection::open(options.endpoint);
    if (!connection)
        return report(connection.error());
    Fields before;
    for (unsigned i = 0; options.count == 0 || i < options.count; ++i) {
        if (i > 0 && !pause_for(options.seconds, *connection))
            break;
        auto now = poll_service(*connection);
        if (!now)
            return report(*connection, now.error());
        if (const std::string news = changes(before, *now); !news.empty()) {
            fmt::print("{:%H:%M:%S}{}\n", fmt::localtime(std::time(nullptr)), news);
            if (std::fflush(stdout) != 0)
                break; // main reports the error, unless the reader closed the pipe
        }
        before = std::move(*now);
    }
    const int number = connection->interrupted();
    return number == 0 ? EX_OK : status_of_signal + number;
}

} // namespace

void add_status(CLI::App& app, Run& run)
{
    CLI::App* const command = app.add_subcommand("status", "prints the state of the service");
    const auto options = std::make_shared<StatusOptions>();
    add_endpoint_options(*command, options->endpoint);
    command->add_flag("--json", options->json, "print the state as a JSON object");
    command->callback([options, &run] { run = [options] { return status(*options); }; });
}

void add_watch(CLI::App& app, Run& run)
{
    CLI::App* const command =
        app.add_subcommand("watch", "prints changes of the state and of the parameters");
    const auto options = std::make_shared<WatchOptions>();
    add_endpoint_options(*command, options->endpoint);
    command
        ->add_option("--interval", options->seconds,
                     "time between two polls of the service, in seconds (default: 1)")
        ->check(CLI::Range(0.01, 3600.0))
        ->type_name("SECONDS");
    command
        ->add_option("--count", options->count,
                     "number of polls of the service; 0, the default, means no limit")
        ->type_name("N");
    command->callback([options, &run] { run = [options] { return watch(*options); }; });
}

} // namespace raymarch::cli
