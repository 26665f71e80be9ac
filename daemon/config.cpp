// SPDX-License-Identifier: MIT
#include "daemon/config.hpp"

#include "base/nearest.hpp"
#include "daemon/actions.hpp"
#include "daemon/setting_values.hpp"

#include <fmt/format.h>

#include <string_view>
#include <variant>
#include <vector>

namespace raymarch::daemon
{
namespace
{

Error no_setting(std::string_view name)
{
    std::vector<std::string_view> names;
    for (const Setting& setting : settings())
        names.push_back(setting.name);
    return plain_error(ErrorKind::Config,
                       fmt::format("there is no setting '{}'{}", name, did_you_mean(name, names)));
}

} // namespace

Error refused_value(std::string_view text, std::string_view allowed)
{
    return plain_error(ErrorKind::Config, fmt::format("'{}' is not {}", text, allowed));
}

Config default_config()
{
    Config config;
    for (const Setting& setting : settings())
        static_cast<void>(setting.set(config, setting.initial)); // a test reads every default
    for (const Action& action : actions())
        config.gpio.lines.push_back(drivers::parse_line_spec(action.line));
    return config;
}

Result<void> set(Config& config, std::string_view name, std::string_view text)
{
    for (const Setting& setting : settings()) {
        if (setting.name != name)
            continue;
        auto result = setting.set(config, text);
        if (!result)
            result.error().message = fmt::format("{}: {}", name, result.error().message);
        return result;
    }
    return fail(no_setting(name));
}

Result<void> validate(const Config& config)
{
    if (auto lines = validate_lines(config.gpio); !lines)
        return lines;
    const bool may_draw = std::holds_alternative<EmulatedRegisters>(config.registers) ||
                          std::holds_alternative<AutoRegisters>(config.registers);
    if (!config.preview.empty() && !may_draw)
        return fail(plain_error(ErrorKind::Config,
                                "preview: only the emulated accelerator's picture can be seen; "
                                "registers must be emulated or auto"));
    const protocol::PictureSize size = config.emulated.size;
    const protocol::PictureSize largest = config.accelerator->max_size;
    if (size.width > largest.width || size.height > largest.height)
        return fail(
            plain_error(ErrorKind::Config,
                        fmt::format("emulated_size: {} draws at most {}x{}",
                                    config.accelerator->name, largest.width, largest.height)));
    return {};
}

} // namespace raymarch::daemon
