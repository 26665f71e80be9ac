// SPDX-License-Identifier: MIT
#include "daemon/options.hpp"

#include "base/nearest.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <sysexits.h>

#include <algorithm>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace raymarch::daemon
{
namespace
{

/// Where the texts of --help begin. No option is one blank shorter: it would touch its text.
constexpr std::size_t help_column = 34;

std::string option_name(std::string_view setting)
{
    std::string name(setting);
    std::ranges::replace(name, '_', '-');
    return "--" + name;
}

/// What is said of a command line that is not understood: of an option that there is not, the
/// nearest one.
std::string explain(const CLI::App* app, const CLI::Error& error)
{
    std::vector<std::string_view> names;
    for (const CLI::Option* option : app->get_options())
        names.insert(names.end(), option->get_lnames().begin(), option->get_lnames().end());
    for (const std::string& left : app->remaining()) {
        const std::string_view word = std::string_view(left).substr(0, left.find('='));
        if (!word.starts_with('-'))
            continue;
        const auto meant =
            nearest(word.substr(std::min(word.find_first_not_of('-'), word.size())), names);
        return fmt::format("raymarchd: there is no option {}{}\nRun raymarchd --help for a list.\n",
                           word, meant ? fmt::format("; did you mean '--{}'?", *meant) : "");
    }
    return CLI::FailureMessage::simple(app, error);
}

} // namespace

std::variant<Options, int> parse_command_line(int argc, const char* const* argv)
{
    Options options;
    CLI::App app("raymarchd: drives a ray-marching accelerator from a serial host", "raymarchd");
    app.get_formatter()->column_width(help_column);
    app.set_version_flag("--version", "raymarchd " RAYMARCH_VERSION);
    app.add_option(
           "--config", options.config_path,
           fmt::format("configuration file (default: {}, if it exists)", default_config_path))
        ->type_name("FILE");
    app.add_flag("--check-config", options.check_config,
                 "read the configuration, report what is wrong with it, and end");
    std::vector<std::string> values(settings().size());
    for (std::size_t i = 0; i < values.size(); ++i) {
        const Setting& setting = settings()[i];
        app.add_option(option_name(setting.name), values[i],
                       fmt::format("{} (default: {})", setting.meaning, setting.initial))
            ->type_name(std::string(setting.value));
    }
    app.failure_message(explain);
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        return app.exit(error) == 0 ? EX_OK : EX_USAGE;
    }
    for (std::size_t i = 0; i < values.size(); ++i)
        if (app.count(option_name(settings()[i].name)) > 0)
            options.settings.emplace_back(settings()[i].name, values[i]);
    return options;
}

Result<Config> load_config(const Options& options)
{
    Config config = default_config();
    const bool named = !options.config_path.empty();
    const std::string path = named ? options.config_path : default_config_path;
    std::error_code ignored;
    if (named || std::filesystem::exists(path, ignored))
        if (auto result = read_config_file(config, path); !result)
            return fail(result.error());
    for (const auto& [name, text] : options.settings)
        if (auto result = set(config, name, text); !result)
            return fail(plain_error(
                ErrorKind::Usage, option_name(name) + result.error().message.substr(name.size())));
    if (auto result = validate(config); !result)
        return fail(result.error());
    return config;
}

} // namespace raymarch::daemon
