// SPDX-License-Identifier: MIT
/// @file
/// Reads the configuration file, which is TOML. What the settings are stands in settings.cpp.
#include "daemon/actions.hpp"
#include "daemon/config.hpp"
#include "daemon/config_text.hpp"
#include "drivers/atomic_file.hpp"

#include <fmt/format.h>

#define TOML_EXCEPTIONS 0
#include <toml++/toml.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace raymarch::daemon
{
namespace
{

constexpr std::size_t largest_config_file = 65'536;

/// A TOML value as the text that the command line would hold.
std::optional<std::string> as_text(const toml::node& node)
{
    if (const auto text = node.value_exact<std::string>())
        return *text;
    if (const auto truth = node.value_exact<bool>())
        return *truth ? "true" : "false";
    if (const auto whole = node.value_exact<std::int64_t>())
        return std::to_string(*whole);
    return std::nullopt;
}

/// Names the type of a value that no setting takes, for a message. It is nullptr for the types that
/// settings take.
const char* unfit(const toml::node& node) noexcept
{
    switch (node.type()) {
    case toml::node_type::table:
        return "a table";
    case toml::node_type::array:
        return "an array";
    case toml::node_type::floating_point:
        return "a number with a fraction or an exponent";
    case toml::node_type::date:
    case toml::node_type::time:
    case toml::node_type::date_time:
        return "a date or a time";
    case toml::node_type::none:
    case toml::node_type::string:
    case toml::node_type::integer:
    case toml::node_type::boolean:
        break;
    }
    return nullptr;
}

/// Makes the error for an entry outside of any table whose value no setting takes.
Result<void> refuse_value(std::string_view name, const toml::node& node)
{
    const bool known = std::ranges::find(settings(), name, &Setting::name) != settings().end();
    Config unused;
    if (!known && !node.is_table())
        return set(unused, name, {}); // makes the error that there is no such setting
    if (!node.is_table())
        return fail(plain_error(
            ErrorKind::Config, fmt::format("{} takes a string, a whole number or a boolean, not {}",
                                           name, unfit(node))));
    return fail(
        plain_error(ErrorKind::Config,
                    fmt::format("there is no table [{}]{}; the only table is [{}]", name,
                                known ? fmt::format(": {} is a setting, {} = VALUE", name, name)
                                      : fmt::format(" and no setting '{}'", name),
                                lines_table)));
}

/// Makes the error for an entry of the table of lines whose value is not the name of a line.
Result<void> refuse_line(std::string_view action, const toml::node& node)
{
    Config unused;
    unused.gpio.lines.resize(actions().size());
    if (auto known = set_line(unused, action, "none"); !known)
        return known;
    return fail(plain_error(ErrorKind::Config, fmt::format("{}.{} takes a string, not {}",
                                                           lines_table, action, unfit(node))));
}

using Apply = Result<void> (*)(Config&, std::string_view, std::string_view);
using Refuse = Result<void> (*)(std::string_view, const toml::node&);

/// Gives one `key = value` of the file to `apply`, or to `refuse` if no setting takes such a value.
Result<void> read_entry(const toml::key& key, const toml::node& node, const std::string& path,
                        Config& config, Apply apply, Refuse refuse)
{
    const auto text = as_text(node);
    auto result = text ? apply(config, key.str(), *text) : refuse(key.str(), node);
    if (!result)
        result.error().message =
            fmt::format("{}:{}: {}", path, key.source().begin.line, result.error().message);
    return result;
}

} // namespace

Result<void> read_config_file(Config& config, const std::string& path)
{
    const auto content = drivers::read_file(path, largest_config_file);
    if (!content)
        return fail(plain_error(ErrorKind::Config, content.error().message));
    return read_config_text(config, *content, path);
}

Result<void> read_config_text(Config& config, std::string_view text, const std::string& path)
{
    if (const auto fault = find_text_fault(text))
        return fail(plain_error(ErrorKind::Config,
                                fmt::format("{}:{}: {}", path, fault->line, fault->what)));
    const toml::parse_result parsed = toml::parse(text, path);
    if (!parsed)
        return fail(plain_error(ErrorKind::Config,
                                fmt::format("{}:{}: {}", path, parsed.error().source().begin.line,
                                            parsed.error().description())));
    for (const auto& [key, node] : parsed.table()) {
        if (key.str() != lines_table) {
            if (auto result = read_entry(key, node, path, config, set, refuse_value); !result)
                return result;
            continue;
        }
        if (!node.is_table())
            return fail(plain_error(ErrorKind::Config, fmt::format("{}:{}: {} is a table, [{}]",
                                                                   path, key.source().begin.line,
                                                                   lines_table, lines_table)));
        for (const auto& [action, line] : *node.as_table())
            if (auto result = read_entry(action, line, path, config, set_line, refuse_line);
                !result)
                return result;
    }
    return {};
}

} // namespace raymarch::daemon
