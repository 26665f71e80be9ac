// SPDX-License-Identifier: MIT
#include "command_line/command_line.hpp"

#include "base/nearest.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace raymarch
{
namespace
{

/// Where the texts of --help begin. No option is one blank shorter: it would touch its text.
constexpr std::size_t help_column = 34;

/// `raymarchctl overlay load`: how the subcommand is called.
std::string called(const CLI::App& app)
{
    const CLI::App* const parent = app.get_parent();
    return parent == nullptr ? app.get_name() : called(*parent) + " " + app.get_name();
}

std::vector<const CLI::App*> children(const CLI::App& app, bool groups)
{
    return app.get_subcommands(
        [groups](const CLI::App* child) { return child->get_name().empty() == groups; });
}

/// The long names of an app's options, and of those in its groups.
void add_option_names(const CLI::App& app, std::vector<std::string_view>& names)
{
    for (const CLI::Option* option : app.get_options())
        for (const std::string& name : option->get_lnames())
            names.emplace_back(name);
    for (const CLI::App* group : children(app, true))
        add_option_names(*group, names);
}

std::string unknown_option(const CLI::App& app, std::string_view word)
{
    word = word.substr(0, word.find('='));
    std::vector<std::string_view> names;
    add_option_names(app, names);
    const std::size_t dashes = std::min(word.find_first_not_of('-'), word.size());
    const auto meant = nearest(word.substr(dashes), names);
    return fmt::format("{0}: there is no option {1}{2}\nRun {0} --help for a list.\n", called(app),
                       word, meant ? fmt::format("; did you mean '--{}'?", *meant) : "");
}

std::string unknown_subcommand(const CLI::App& app, std::string_view word)
{
    std::vector<std::string_view> names;
    for (const CLI::App* child : children(app, false))
        names.emplace_back(child->get_name());
    return fmt::format("{0}: there is no subcommand '{1}'; the subcommands are {2}{3}\nRun {0} "
                       "--help for a list.\n",
                       called(app), word, fmt::join(names, ", "), did_you_mean(word, names));
}

/// Returns what is wrong with the first word that is no option, or no subcommand, of `app`.
std::optional<std::string> unknown_word(const CLI::App& app)
{
    const bool wants_subcommand = !children(app, false).empty() && app.get_subcommands().empty();
    for (const std::string& word : app.remaining()) {
        if (word.starts_with('-'))
            return unknown_option(app, word);
        if (wants_subcommand)
            return unknown_subcommand(app, word);
    }
    return std::nullopt;
}

std::string explain(const CLI::App* app, const CLI::Error& error)
{
    // An option that is missing may be the one that is spelt wrong.
    const bool about_words = dynamic_cast<const CLI::ExtrasError*>(&error) != nullptr ||
                             dynamic_cast<const CLI::RequiredError*>(&error) != nullptr;
    for (const CLI::App* at = app; about_words && at != nullptr;) {
        if (auto text = unknown_word(*at))
            return *text;
        const auto chosen = at->get_subcommands();
        at = chosen.empty() ? nullptr : chosen.back();
    }
    return CLI::FailureMessage::simple(app, error);
}

} // namespace

void prepare_command_line(CLI::App& app)
{
    app.failure_message(explain);
    app.get_formatter()->column_width(help_column);
}

} // namespace raymarch
