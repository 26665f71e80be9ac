// SPDX-License-Identifier: MIT
/// @file
/// `raymarchctl console`: a line editor with history and completion. If standard input is not a
/// terminal, its lines are sent unchanged.
#include "cli/connection.hpp"
#include "cli/history_file.hpp"
#include "cli/subcommands.hpp"
#include "cli/typed_lines.hpp"
#include "protocol/accelerators.hpp"
#include "protocol/text.hpp"

#include <fmt/format.h>
#include <sysexits.h>
#include <unistd.h>

#include <array>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <string>
#include <string_view>

namespace raymarch::cli
{
namespace
{

constexpr const char* prompt = "raymarch> ";

/// A word that the console itself handles. If standard input is not a terminal, it is sent like any
/// other line.
struct ConsoleWord
{
    std::string_view word;
    std::string_view replacement; ///< the line that is sent; if empty, the console ends
};
constexpr std::array console_words = {
    ConsoleWord{"quit", ""},
    ConsoleWord{"exit", ""},
    ConsoleWord{"?", "HELP"},
};
constexpr const char* greeting =
    "HELP or ? shows the commands; Tab completes a word; quit, exit or Ctrl-D ends the console.\n";

const ConsoleWord* find_console_word(std::string_view line)
{
    const std::string_view typed = protocol::Text{line}.trimmed().bytes;
    for (const ConsoleWord& row : console_words)
        if (protocol::equal_ignoring_case(row.word, typed))
            return &row;
    return nullptr;
}

/// Warns the user that most lines will have no reply.
void warn_of(FarEnd far_end)
{
    if (far_end == FarEnd::Silent)
        fmt::print(stderr, "raymarchctl: nothing answers at the far end, or the service's setting "
                           "replies is none\n");
    if (far_end == FarEnd::OnlyErrors)
        fmt::print(stderr, "raymarchctl: the far end sends only ERR replies (the service's setting "
                           "replies)\n");
}

/// The keys of `active` complete. The pointer must live as long as the lines.
std::unique_ptr<TypedLines> lines_of_a_person(int stop_fd, const protocol::Accelerator*& active)
{
    const char* const state = std::getenv("XDG_STATE_HOME"); // NOLINT(concurrency-mt-unsafe)
    const char* const home = std::getenv("HOME");            // NOLINT(concurrency-mt-unsafe)
    const auto completes = [&active](std::string_view before) { return complete(*active, before); };
    auto lines = edited_lines(stop_fd, prompt, history_file(state, home), completes);
    if (lines == nullptr) {
        fmt::print(stderr, "raymarchctl: there is no line editor, because the locale C.UTF-8 is "
                           "missing or the terminal is unknown\n");
        return plain_lines(stop_fd, prompt);
    }
    fmt::print("{}", greeting);
    return lines;
}

int converse(const Endpoint& endpoint)
{
    auto connection = Connection::open(endpoint);
    if (!connection)
        return report(connection.error());
    warn_of(connection->far_end());
    const protocol::Accelerator* active = connection->accelerator();
    if (active == nullptr)
        active = &protocol::default_accelerator;

    const bool person = ::isatty(STDIN_FILENO) != 0;
    const auto lines = person ? lines_of_a_person(connection->stop_fd(), active)
                              : plain_lines(connection->stop_fd(), "");
    bool refused = false;
    for (;;) {
        auto line = lines->next();
        if (!line)
            return report(line.error());
        const int signal = connection->interrupted();
        if (person && signal == SIGINT) { // the line is dropped, as in a shell
            connection->forget_interruption();
            fmt::print("^C\n");
            continue;
        }
        if (signal != 0 || !*line) {
            if (person)
                fmt::print("\n");
            return signal != 0          ? status_of_signal + signal
                   : !person && refused ? status_err_reply
                                        : EX_OK;
        }
        if (const ConsoleWord* const word = person ? find_console_word(**line) : nullptr) {
            if (word->replacement.empty())
                return EX_OK;
            *line = word->replacement;
        }
        if (replies_due(**line) == 0)
            continue;
        const auto reply = ask_and_print(*connection, **line);
        if (!reply)
            return report(*connection, reply.error());
        if (const protocol::Accelerator* const named = accelerator_of(*reply))
            active = named; // NOLINT(clang-analyzer-deadcode.DeadStores): completion reads it
        refused |= is_err(*reply);
        if (std::fflush(stdout) != 0)
            return EX_OK; // main reports the error, unless the reader closed the pipe
    }
}

} // namespace

void add_console(CLI::App& app, Run& run)
{
    CLI::App* const command =
        app.add_subcommand("console", "opens an interactive line editor on the service");
    const auto endpoint = std::make_shared<Endpoint>();
    add_endpoint_options(*command, *endpoint);
    command->callback([endpoint, &run] { run = [endpoint] { return converse(*endpoint); }; });
}

} // namespace raymarch::cli
