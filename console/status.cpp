// SPDX-License-Identifier: MIT
/// @file
/// `raymarchctl status` and `watch`: what the service says of itself, once or as it changes.
#include "console/connection.hpp"
#include "console/subcommands.hpp"

#include <fmt/chrono.h>
#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <sysexits.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <ctime>
#include <memory>
#include <sstream>
#include <string>
#include <thread>
#include <utility>
#include <vector>

namespace raymarch::console
{
namespace
{

using Fields = std::vector<std::pair<std::string, std::string>>;

/// `OK key=value key=value` or `OK KEY=VALUE,KEY=VALUE` to pairs.
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

Result<Fields> ask_fields(Connection& connection, const char* command)
{
    const auto replies = connection.ask(command);
    if (!replies)
        return fail(replies.error());
    if (is_err(replies->back()))
        return fail(
            plain_error(ErrorKind::InputOutput, fmt::format("{}: {}", command, replies->back())));
    return fields_of(replies->back());
}

/// Numbers as numbers, everything else as text.
nlohmann::json json_of(const Fields& fields)
{
    nlohmann::json object = nlohmann::json::object();
    for (const auto& [key, value] : fields) {
        auto parsed = nlohmann::json::parse(value, nullptr, false);
        object[key] = parsed.is_number() ? std::move(parsed) : nlohmann::json(value);
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
        return report(fields.error());
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

/// These move all the time; a change of them alone is no news.
bool always_moves(std::string_view key)
{
    return key == "uptime" || key == "fps";
}

std::string changes(const Fields& before, const Fields& now)
{
    std::string text;
    for (const auto& field : now)
        if (!always_moves(field.first) &&
            std::find(before.begin(), before.end(), field) == before.end())
            text += fmt::format(" {}={}", field.first, field.second);
    return text;
}

int watch(const WatchOptions& options)
{
    auto connection = Connection::open(options.endpoint);
    if (!connection)
        return report(connection.error());
    Fields before;
    for (unsigned i = 0; options.count == 0 || i < options.count; ++i) {
        if (i > 0)
            std::this_thread::sleep_for(std::chrono::duration<double>(options.seconds));
        auto now = ask_fields(*connection, "STATUS");
        const auto parameters = ask_fields(*connection, "GET");
        if (!now || !parameters)
            return report(now ? parameters.error() : now.error());
        now->insert(now->end(), parameters->begin(), parameters->end());
        if (const std::string news = changes(before, *now); !news.empty()) {
            fmt::print("{:%H:%M:%S}{}\n", fmt::localtime(std::time(nullptr)), news);
            static_cast<void>(std::fflush(stdout)); // main reports what could not be written
        }
        before = std::move(*now);
    }
    return EX_OK;
}

} // namespace

void add_status(CLI::App& app, Run& run)
{
    CLI::App* const command = app.add_subcommand("status", "the state of the service");
    const auto options = std::make_shared<StatusOptions>();
    add_endpoint_options(*command, options->endpoint);
    command->add_flag("--json", options->json, "as a JSON object");
    command->callback([options, &run] { run = [options] { return status(*options); }; });
}

void add_watch(CLI::App& app, Run& run)
{
    CLI::App* const command =
        app.add_subcommand("watch", "prints what changes of the state and the parameters");
    const auto options = std::make_shared<WatchOptions>();
    add_endpoint_options(*command, options->endpoint);
    command->add_option("--interval", options->seconds, "between two looks (default: 1)")
        ->check(CLI::Range(0.01, 3600.0))
        ->type_name("SECONDS");
    command->add_option("--count", options->count, "looks, then ends; 0 (default) goes on")
        ->type_name("N");
    command->callback([options, &run] { run = [options] { return watch(*options); }; });
}

} // namespace raymarch::console
