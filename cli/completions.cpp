// SPDX-License-Identifier: MIT
#include "cli/completions.hpp"

#include "protocol/commands.hpp"
#include "protocol/text.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace raymarch::cli
{
namespace
{

void add_keys(const protocol::Accelerator& active, std::vector<std::string>& words,
              std::string_view suffix)
{
    for (const protocol::Parameter& parameter : active.parameters)
        if (!parameter.is_tail())
            words.push_back(fmt::format("{}{}", parameter.key, suffix));
}

void add_commands(std::vector<std::string>& words)
{
    for (const protocol::CommandRow& row : protocol::commands)
        words.emplace_back(row.name);
}

void add_groups(const protocol::Accelerator& active, std::vector<std::string>& words)
{
    for (const protocol::Parameter& parameter : active.parameters)
        if (words.empty() || words.back() != parameter.group)
            words.emplace_back(parameter.group);
}

/// Adds the words that an argument may be.
void add_values(const protocol::Accelerator& active, const protocol::ArgumentRow& argument,
                std::vector<std::string>& words)
{
    using Kind = protocol::ArgumentKind;
    switch (argument.kind) {
    case Kind::Assignments:
        return add_keys(active, words, "=");
    case Kind::Keys:
        return add_keys(active, words, "");
    case Kind::Choice:
        words.insert(words.end(), argument.names.begin(), argument.names.end());
        return;
    case Kind::Group:
        return add_groups(active, words);
    case Kind::Preset:
        for (const protocol::Preset& preset : active.presets)
            words.emplace_back(preset.name);
        return;
    case Kind::Accelerator:
        for (const protocol::Accelerator* accelerator : protocol::accelerators)
            words.emplace_back(accelerator->name);
        return;
    case Kind::Topic:
        add_commands(words);
        return add_keys(active, words, "");
    case Kind::None:
    case Kind::Number:
    case Kind::Zoom:
    case Kind::Count:
        return;
    }
}

} // namespace

std::vector<std::string> words_for(const protocol::Accelerator& active, std::string_view before)
{
    std::vector<std::string> words;
    if (before.find_first_not_of(" \t") == std::string_view::npos) {
        add_commands(words);
        add_keys(active, words, "=");
        return words;
    }
    if (before.ends_with('=')) { // a value follows
        const std::size_t key_begin = before.find_last_of(" ,") + 1;
        const std::string_view key = before.substr(key_begin, before.size() - 1 - key_begin);
        if (const auto index = protocol::find_parameter(active, key))
            for (const std::string_view choice : active.parameters[*index].choices)
                words.emplace_back(choice);
        return words;
    }
    const std::string_view first = protocol::Text{before}.trimmed().bytes;
    const protocol::CommandRow* const command =
        protocol::find_command(first.substr(0, first.find_first_of(" \t")));
    if (command == nullptr) { // the next pair of a frame
        add_keys(active, words, "=");
        return words;
    }
    for (const protocol::ArgumentRow& argument : command->arguments)
        add_values(active, argument, words);
    return words;
}

Completion complete(const protocol::Accelerator& active, std::string_view before)
{
    const std::size_t start = before.find_last_of(" \t,=") + 1;
    const std::string_view typed = before.substr(start);
    Completion found{.typed = typed.size()};
    for (std::string& word : words_for(active, before.substr(0, start)))
        if (protocol::equal_ignoring_case(std::string_view(word).substr(0, typed.size()), typed))
            found.words.push_back(std::move(word));
    if (found.words.empty())
        return found;
    found.text = found.words.front();
    for (const std::string& word : found.words) {
        std::size_t same = 0;
        while (same < std::min(word.size(), found.text.size()) && word[same] == found.text[same])
            ++same;
        found.text.resize(same);
    }
    // A complete word gets a blank, except `KEY=`, because a value follows.
    if (found.words.size() == 1 && !found.text.ends_with('='))
        found.text += ' ';
    return found;
}

} // namespace raymarch::cli
