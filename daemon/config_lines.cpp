// SPDX-License-Identifier: MIT
/// @file
/// The lines that the configuration gives to the actions of buttons, switches and LEDs.
#include "base/nearest.hpp"
#include "daemon/actions.hpp"
#include "daemon/setting_values.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <optional>
#include <string_view>
#include <utility>
#include <vector>

namespace raymarch::daemon
{

Result<void> set_line(Config& config, std::string_view action, std::string_view text)
{
    std::vector<std::string_view> names;
    for (std::size_t i = 0; i < actions().size(); ++i) {
        const Action& row = actions()[i];
        names.push_back(row.name);
        if (row.name != action)
            continue;
        const auto spec = drivers::parse_line_spec(text);
        const auto refused = [&](std::string_view allowed) {
            Error error = refused_value(text, allowed);
            error.message = fmt::format("{}.{}: {}", lines_table, action, error.message);
            return fail(std::move(error));
        };
        if (text != "none" && !spec)
            return refused(fmt::format("none or {}", line_values));
        if (text != "none" && row.kind == ActionKind::Led && spec->pull != drivers::Pull::AsIs)
            return refused("for an LED, which has no pull");
        config.gpio.lines[i] = text == "none" ? std::nullopt : spec;
        return {};
    }
    return fail(
        plain_error(ErrorKind::Config,
                    fmt::format("{}: unknown action '{}'; there are {}{}", lines_table, action,
                                fmt::join(names, ", "), did_you_mean(action, names))));
}

Result<void> validate_lines(const Gpio& gpio)
{
    for (std::size_t i = 0; i < gpio.lines.size(); ++i)
        for (std::size_t j = 0; j < i; ++j)
            if (gpio.lines[i] && gpio.lines[j] &&
                gpio.lines[i]->places.front() == gpio.lines[j]->places.front())
                return fail(plain_error(ErrorKind::Config,
                                        fmt::format("{}: {} and {} are both {}", lines_table,
                                                    actions()[j].name, actions()[i].name,
                                                    to_string(gpio.lines[i]->places.front()))));
    return {};
}

} // namespace raymarch::daemon
