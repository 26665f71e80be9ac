// SPDX-License-Identifier: MIT
/// @file
/// `raymarchctl console`: a line editor on the service, with history and completion.
#include "console/connection.hpp"
#include "console/subcommands.hpp"
#include "protocol/accelerators.hpp"
#include "protocol/commands.hpp"

#include <editline/readline.h>
#include <fmt/format.h>
#include <sysexits.h>
#include <unistd.h>

#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace raymarch::console
{
namespace
{

namespace fs = std::filesystem;

/// What completion may offer; libedit's callbacks take no context, so it stands here.
std::vector<std::string> candidates; // NOLINT(cppcoreguidelines-avoid-non-const-global-variables)

/// Whose keys complete: what the service said last.
// NOLINTNEXTLINE(cppcoreguidelines-avoid-non-const-global-variables)
const protocol::Accelerator* active = &protocol::default_accelerator;

/// `OK accelerator=NAME …`, the reply to ACCELERATOR and to STATUS.
void note_accelerator(std::string_view reply)
{
    constexpr std::string_view front = "OK accelerator=";
    if (!reply.starts_with(front))
        return;
    const std::string_view name = reply.substr(front.size());
    if (const auto* const found = protocol::find_accelerator(name.substr(0, name.find(' '))))
        active = found;
}

void add_keys(std::vector<std::string>& words, std::string_view behind)
{
    for (const protocol::Parameter& parameter : active->parameters)
        if (!parameter.is_tail())
            words.push_back(fmt::format("{}{}", parameter.key, behind));
}

void add_commands(std::vector<std::string>& words)
{
    for (const protocol::CommandRow& row : protocol::commands)
        words.emplace_back(row.name);
}

void add_groups(std::vector<std::string>& words)
{
    for (const protocol::Parameter& parameter : active->parameters)
        if (words.empty() || words.back() != parameter.group)
            words.emplace_back(parameter.group);
}

/// What may stand at the place of the word that begins at `start` of `line`.
std::vector<std::string> words_for(std::string_view line, std::size_t start)
{
    std::vector<std::string> words;
    const std::string_view before = line.substr(0, start);
    if (before.find_first_not_of(" \t") == std::string_view::npos) {
        add_commands(words);
        add_keys(words, "=");
        return words;
    }
    if (before.ends_with('=')) { // the value of a choice
        const std::size_t key_begin = before.find_last_of(" ,") + 1;
        const std::string_view key = before.substr(key_begin, before.size() - 1 - key_begin);
        if (const auto index = protocol::find_parameter(active->parameters, key))
            for (const std::string_view choice : active->parameters[*index].choices)
                words.emplace_back(choice);
        return words;
    }
    const std::string_view first = protocol::Text{before}.trimmed().bytes;
    const protocol::CommandRow* const command =
        protocol::find_command(first.substr(0, first.find_first_of(" \t")));
    if (command == nullptr) { // the next pair of a frame
        add_keys(words, "=");
        return words;
    }
    switch (command->id) {
    case protocol::CommandId::Set:
        add_keys(words, "=");
        break;
    case protocol::CommandId::Get:
        add_keys(words, "");
        break;
    case protocol::CommandId::Reset:
    case protocol::CommandId::Random:
        add_groups(words);
        break;
    case protocol::CommandId::Preset:
        for (const protocol::Preset& preset : active->presets)
            words.emplace_back(preset.name);
        break;
    case protocol::CommandId::Echo:
    case protocol::CommandId::Animate:
        words = {"on", "off"};
        break;
    case protocol::CommandId::Accelerator:
        for (const protocol::Accelerator* accelerator : protocol::accelerators)
            words.emplace_back(accelerator->name);
        break;
    case protocol::CommandId::Walk:
        words.assign(protocol::walk_directions.begin(), protocol::walk_directions.end());
        break;
    case protocol::CommandId::Turn:
        words.assign(protocol::turn_directions.begin(), protocol::turn_directions.end());
        break;
    case protocol::CommandId::Help:
        add_commands(words);
        add_keys(words, "");
        break;
    case protocol::CommandId::View:
    case protocol::CommandId::Hue:
    case protocol::CommandId::Regs:
    case protocol::CommandId::Status:
    case protocol::CommandId::Save:
    case protocol::CommandId::Load:
    case protocol::CommandId::Version:
    case protocol::CommandId::Ping:
        break;
    }
    return words;
}

/// One match after the other, each in memory that the library frees.
char* next_match(const char* text, int state)
{
    static std::size_t at = 0;
    if (state == 0)
        at = 0;
    const std::string_view typed = text;
    while (at < candidates.size()) {
        const std::string& word = candidates[at++];
        if (protocol::equal_ignoring_case(word.substr(0, typed.size()), typed))
            return ::strdup(word.c_str());
    }
    return nullptr;
}

char** complete(const char* text, int start, int /*end*/)
{
    candidates = words_for(rl_line_buffer, static_cast<std::size_t>(start));
    rl_attempted_completion_over = 1; // never file names
    const bool pair = !candidates.empty() && candidates.back().ends_with('=');
    rl_completion_append_character = pair ? 0 : 0x20; // nothing behind `KEY=`, else a space
    return rl_completion_matches(text, next_match);
}

std::string history_file()
{
    const char* const state = std::getenv("XDG_STATE_HOME"); // NOLINT(concurrency-mt-unsafe)
    const char* const home = std::getenv("HOME");            // NOLINT(concurrency-mt-unsafe)
    if (state == nullptr && home == nullptr)
        return {};
    const fs::path folder = state != nullptr ? fs::path(state) : fs::path(home) / ".local/state";
    std::error_code ignored;
    fs::create_directories(folder, ignored);
    const fs::path history = folder / "raymarchctl_history";
    const fs::file_status there = fs::status(history, ignored);
    if (fs::exists(there) && !fs::is_regular_file(there)) // libedit would wait for a FIFO
        return {};
    return history;
}

int converse(const Endpoint& endpoint)
{
    auto connection = Connection::open(endpoint);
    if (!connection)
        return report(connection.error());
    const bool person = ::isatty(STDIN_FILENO) != 0;
    if (const auto replies = connection->ask("ACCELERATOR"))
        note_accelerator(replies->back());
    if (person)
        fmt::print("HELP explains; Tab completes; Ctrl-D ends.\n");

    rl_initialize();
    static char break_characters[] = " \t,="; // NOLINT: libedit wants to own a char*
    rl_completer_word_break_characters = break_characters;
    rl_attempted_completion_function = complete;
    using_history();
    const std::string history = history_file();
    read_history(history.c_str());

    bool refused = false;
    while (char* const typed = readline(person ? "raymarch> " : "")) {
        const std::unique_ptr<char, decltype(&std::free)> owner(typed, &std::free);
        const std::string line = typed;
        if (line.find_first_not_of(" \t") == std::string::npos)
            continue;
        add_history(typed);
        const auto reply = ask_and_print(*connection, line);
        if (!reply)
            return report(reply.error());
        note_accelerator(*reply);
        refused |= is_err(*reply);
    }
    if (person) {
        fmt::print("\n");
        write_history(history.c_str());
        return EX_OK;
    }
    return refused ? status_err_reply : EX_OK;
}

} // namespace

void add_console(CLI::App& app, Run& run)
{
    CLI::App* const command =
        app.add_subcommand("console", "an interactive line editor on the service");
    const auto endpoint = std::make_shared<Endpoint>();
    add_endpoint_options(*command, *endpoint);
    command->callback([endpoint, &run] { run = [endpoint] { return converse(*endpoint); }; });
}

} // namespace raymarch::console
