// SPDX-License-Identifier: MIT
/// @file
/// `raymarchctl conformance`: runs the protocol's tables against a live endpoint: this service, a
/// board over its UART, or another implementation.
///
/// Rows about the active accelerator are made from its description. The table files are about the
/// marcher, so the endpoint is switched to the marcher for them, and back. If it cannot be
/// switched, as on a board, the files are left out.
#include "cli/conformance_tables.hpp"
#include "cli/connection.hpp"
#include "cli/subcommands.hpp"
#include "conformance/description_rows.hpp"
#include "conformance/table.hpp"
#include "protocol/accelerators.hpp"

#include <fmt/format.h>
#include <sysexits.h>

#include <algorithm>
#include <cstdlib>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace raymarch::cli
{
namespace
{

constexpr std::string_view active_reply = "OK accelerator=";

/// The table files are about this accelerator.
constexpr const protocol::Accelerator& table_accelerator = protocol::marcher::description;

struct ConformanceOptions
{
    Endpoint endpoint;
    bool verbose = false;
};

/// Returns the first byte, counted from 1, at which a reply does not match its pattern: the byte
/// after the longest prefix of the reply that a prefix of the pattern matches.
std::size_t first_difference(std::string_view pattern, std::string_view reply)
{
    for (std::size_t length = std::min(reply.size(), reply.find(" : ")); length > 0; --length)
        for (std::size_t i = 1; i <= pattern.size(); ++i)
            if (conformance::match(pattern.substr(0, i), reply.substr(0, length)))
                return length + 1;
    return 1;
}

/// Returns the words in a reply to REGS, or nothing if it is another reply.
std::optional<std::vector<std::uint32_t>> words_of(std::string_view reply)
{
    std::vector<std::uint32_t> words;
    if (!reply.starts_with("OK "))
        return std::nullopt;
    std::string text(reply.substr(3));
    for (std::size_t at = 0; at < text.size(); at += 9) {
        char* end = nullptr;
        words.push_back(static_cast<std::uint32_t>(std::strtoul(text.c_str() + at, &end, 16)));
        if (end != text.c_str() + at + 8)
            return std::nullopt;
    }
    return words;
}

std::string hex(const std::vector<std::uint32_t>& words)
{
    std::string text;
    for (const std::uint32_t word : words)
        text += fmt::format("{}{:08X}", text.empty() ? "" : " ", word);
    return text;
}

class Runner
{
  public:
    Runner(Connection& connection, bool verbose) : connection_(connection), verbose_(verbose) {}

    /// Errors: InputOutput, if the endpoint cannot be reset to the defaults.
    Result<void> run(const ConformanceTable& table)
    {
        const auto rows = conformance::parse_table(table.text);
        if (!rows)
            return fail(plain_error(ErrorKind::BadData, rows.error().message));
        return run(fmt::format("{}.tsv", table.name), *rows);
    }

    /// `name` and the row's line identify a failing row. Errors: as above.
    Result<void> run(std::string_view name, const std::vector<conformance::Row>& rows)
    {
        if (const auto reset = connection_.request("RESET"); !reset)
            return fail(reset.error());
        const auto start = connection_.request("REGS");
        if (!start)
            return fail(start.error());
        before_ = words_of(*start).value_or(std::vector<std::uint32_t>());
        for (const conformance::Row& row : rows)
            if (auto judged = judge(name, row); !judged)
                return judged;
        return {};
    }

    [[nodiscard]] unsigned passed() const noexcept { return passed_; }
    [[nodiscard]] unsigned failed() const noexcept { return failed_; }

  private:
    /// A row that is made from a description has no line.
    static std::string place(std::string_view name, const conformance::Row& row)
    {
        return row.line == 0 ? std::string(name) : fmt::format("{}:{}", name, row.line);
    }

    /// Errors: InputOutput, if the endpoint does not reply any more.
    Result<void> judge(std::string_view name, const conformance::Row& row)
    {
        const std::string difference = run_row(row);
        if (difference.empty()) {
            ++passed_;
            if (verbose_)
                fmt::print("ok {} {}\n", place(name, row), row.why);
            return {};
        }
        ++failed_;
        fmt::print("FAILED {} {}\n  sent     {}\n{}", place(name, row), row.why, visible(row.send),
                   difference);
        if (auto again = connection_.synchronise(); !again) // the next row starts in a known state
            return again;
        const auto now = connection_.request("REGS");
        if (!now)
            return fail(now.error());
        before_ = words_of(*now).value_or(before_);
        return {};
    }

    Result<std::string> next_line()
    {
        auto line = connection_.receive();
        if (!line)
            return fail(line.error());
        if (!*line)
            return fail(plain_error(ErrorKind::InputOutput, "no reply came in time"));
        return std::move(**line);
    }

    /// Returns the differences, or an empty string. REGS is sent after the row's bytes; its reply
    /// tells that the row has no more replies, and shows the words.
    std::string run_row(const conformance::Row& row)
    {
        const std::string regs = connection_.request_line("REGS") + "\n";
        if (const auto sent = connection_.send(row.send + regs); !sent)
            return fmt::format("  {}\n", sent.error().message);
        for (const std::string& pattern : row.replies) {
            const auto reply = next_line();
            if (!reply)
                return fmt::format("  expected {}\n  {}\n", pattern, reply.error().message);
            if (!conformance::match(pattern, *reply))
                return fmt::format("  expected {}\n  got      {}\n  differs from byte {} on\n",
                                   pattern, visible(*reply), first_difference(pattern, *reply));
        }
        const auto last = next_line();
        if (!last)
            return fmt::format("  expected the reply to REGS\n  {}\n", last.error().message);
        const auto words = words_of(without_mark(*last));
        if (!words)
            return fmt::format("  expected no further reply\n  got      {}\n", visible(*last));
        const std::vector<std::uint32_t> old = std::exchange(before_, *words);
        const auto& wanted = row.words_check == conformance::WordsCheck::Same ? old : row.words;
        if (row.words_check != conformance::WordsCheck::Unchecked && *words != wanted)
            return fmt::format("  expected words {}\n  got      words {}\n", hex(wanted),
                               hex(*words));
        return {};
    }

    Connection& connection_;
    bool verbose_;
    std::vector<std::uint32_t> before_;
    unsigned passed_ = 0;
    unsigned failed_ = 0;
};

/// Returns the active accelerator of the endpoint. If it does not know the command, it has the
/// accelerator of the tables. Errors: Unavailable, if the accelerator is unknown here; InputOutput.
Result<const protocol::Accelerator*> active_accelerator(Connection& connection)
{
    const auto reply = connection.request("ACCELERATOR");
    if (!reply)
        return fail(reply.error());
    if (!reply->starts_with(active_reply))
        return &table_accelerator;
    if (const protocol::Accelerator* found = accelerator_of(*reply))
        return found;
    return fail(
        plain_error(ErrorKind::Unavailable,
                    fmt::format("the endpoint's accelerator '{}' is unknown",
                                visible(std::string_view(*reply).substr(active_reply.size())))));
}

/// Returns false if the endpoint does not switch. Errors: InputOutput.
Result<bool> switch_to(Connection& connection, const protocol::Accelerator& accelerator)
{
    const auto reply = connection.request(fmt::format("ACCELERATOR {}", accelerator.name));
    if (!reply)
        return fail(reply.error());
    return reply->starts_with(active_reply);
}

Result<void> run_tables(Runner& runner)
{
    for (const ConformanceTable& table : conformance_tables())
        if (const auto result = runner.run(table); !result)
            return fail(plain_error(result.error().kind,
                                    fmt::format("{}: {}", table.name, result.error().message)));
    return {};
}

/// Runs all rows. Afterwards the endpoint has its old accelerator with the defaults.
Result<void> run_all(Connection& connection, Runner& runner)
{
    const auto active = active_accelerator(connection);
    if (!active)
        return fail(active.error());
    const protocol::Accelerator& own = **active;
    if (auto result = runner.run(own.name, conformance::description_rows(own)); !result)
        return result;
    if (&own != &table_accelerator) {
        const auto switched = switch_to(connection, table_accelerator);
        if (!switched)
            return fail(switched.error());
        if (!*switched) {
            fmt::print("the endpoint stays with {}: the tables, which are about {}, are left out\n",
                       own.name, table_accelerator.name);
            return {};
        }
    }
    if (auto result = run_tables(runner); !result)
        return result;
    static_cast<void>(connection.request("RESET"));
    if (&own != &table_accelerator)
        static_cast<void>(switch_to(connection, own));
    return {};
}

int run_conformance(const ConformanceOptions& options)
{
    auto connection = Connection::open(options.endpoint);
    if (!connection)
        return report(connection.error());
    Runner runner(*connection, options.verbose);
    const auto result = run_all(*connection, runner);
    if (!result)
        fmt::print(stderr, "raymarchctl: {}\n", result.error().message);
    fmt::print("{} passed, {} failed\n", runner.passed(), runner.failed());
    if (const int number = connection->interrupted(); number != 0)
        return status_of_signal + number;
    if (!result)
        return EX_UNAVAILABLE;
    return runner.failed() == 0 ? EX_OK : status_err_reply;
}

} // namespace

void add_conformance(CLI::App& app, Run& run)
{
    CLI::App* const command = app.add_subcommand(
        "conformance",
        "runs the protocol's tests against a live endpoint, and prints how many rows pass");
    const auto options = std::make_shared<ConformanceOptions>();
    add_endpoint_options(*command, options->endpoint);
    command->add_flag("--verbose", options->verbose, "also print the rows that pass");
    command->callback([options, &run] { run = [options] { return run_conformance(*options); }; });
}

} // namespace raymarch::cli
