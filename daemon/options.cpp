// SPDX-License-Identifier: MIT
#include "daemon/options.hpp"

#include "command_line/command_line.hpp"

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

std::string option_name(std::string_view setting)
{
    std::string name(setting);
    std::ranges::replace(name, '_', '-');
    return "--" + name;
}

} // namespace

std::variant<Options, int> parse_command_line(int argc, const char* const* argv)
{
    Options options;
    CLI::App app("raymarchd: drives a ray-marching accelerator from a serial host", "raymarchd");
    prepare_command_line(app);
    app.set_version_flag("--version", "raymarchd " RAYMARCH_VERSION);
    app.add_option(
           "--config", options.config_path,
           fmt::format("configuration file (default: {}, if it exists)", default_config_path))
        ->type_name("FILE");
    app.add_flag("--check-config", options.check_config,
                 "check the configuration, report its errors, and exit");
    std::vector<std::string> values(settings().size());
    for (std::size_t i = 0; i < values.size(); ++i) {
        const Setting& setting = settings()[i];
        app.add_option(option_name(setting.name), values[i],
                       fmt::format("{} (default: {})", setting.meaning, setting.initial))
            ->type_name(std::string(setting.value));
    }
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
