// SPDX-License-Identifier: MIT
/// @file
/// TABLE: the settings, each with the function that takes its value.
#include "base/nearest.hpp"
#include "daemon/setting_values.hpp"
#include "drivers/unix_socket.hpp"
#include "protocol/accelerators.hpp"
#include "protocol/commands.hpp"
#include "protocol/picture_size.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <array>
#include <charconv>
#include <optional>
#include <string>
#include <vector>

namespace raymarch::daemon
{
namespace
{

std::optional<unsigned> number(std::string_view text)
{
    unsigned value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc{} || end != text.data() + text.size())
        return std::nullopt;
    return value;
}

/// Sets `target` to the enumerator at the position of `text` in `names`.
template <typename Enum, std::size_t N>
Result<void> set_choice(Enum& target, std::string_view text,
                        const std::array<std::string_view, N>& names, std::string_view allowed)
{
    for (std::size_t i = 0; i < N; ++i) {
        if (names[i] == text) {
            target = static_cast<Enum>(i);
            return {};
        }
    }
    return fail(refused_value(text, allowed));
}

Result<void> set_gpio(Config& config, std::string_view text)
{
    return set_choice<bool, 2>(config.gpio.used, text, {"none", "lines"}, "lines or none");
}

Result<void> set_gpio_debounce(Config& config, std::string_view text)
{
    constexpr unsigned longest = 1000;
    const auto milliseconds = number(text);
    if (!milliseconds || *milliseconds > longest)
        return fail(refused_value(text, fmt::format("a number of milliseconds, 0 to {}", longest)));
    config.gpio.debounce = std::chrono::milliseconds(*milliseconds);
    return {};
}

Result<void> set_rate(unsigned& target, std::string_view text)
{
    const auto rate = number(text);
    if (!rate || *rate < 1 || *rate > protocol::most_rate)
        return fail(refused_value(
            text, fmt::format("a number of steps a second, 1 to {}", protocol::most_rate)));
    target = *rate;
    return {};
}

Result<void> set_gpio_orbit_rate(Config& config, std::string_view text)
{
    return set_rate(config.gpio.orbit_rate, text);
}

Result<void> set_gpio_turn_rate(Config& config, std::string_view text)
{
    return set_rate(config.gpio.turn_rate, text);
}

/// Stores a path in `target`; `none` empties it.
Result<void> set_path(std::string& target, std::string_view text)
{
    if (text.empty())
        return fail(refused_value(text, "a path or none"));
    target = text == "none" ? std::string_view() : text;
    return {};
}

Result<void> set_state(Config& config, std::string_view text)
{
    return set_path(config.state, text);
}

Result<void> set_control(Config& config, std::string_view text)
{
    if (text.size() > drivers::max_socket_path)
        return fail(refused_value(
            text, fmt::format("a path of at most {} bytes", drivers::max_socket_path)));
    return set_path(config.control, text);
}

Result<void> set_preview(Config& config, std::string_view text)
{
    if (text != "none" && !text.ends_with(".png"))
        return fail(refused_value(text, "FILE.png or none"));
    return set_path(config.preview, text);
}

Result<void> set_sysfs_root(Config& config, std::string_view text)
{
    if (!text.starts_with('/'))
        return fail(refused_value(text, "a path from / on"));
    config.sysfs_root = text;
    return {};
}

Result<void> set_log_level(Config& config, std::string_view text)
{
    const auto level = log::level_named(text);
    if (!level)
        return fail(refused_value(text, "error, warning, notice, info or debug"));
    config.log_level = *level;
    return {};
}

Result<void> set_accelerator(Config& config, std::string_view text)
{
    const protocol::Accelerator* const found = protocol::find_accelerator(text);
    if (found == nullptr) {
        std::vector<std::string_view> names;
        names.reserve(protocol::accelerators.size());
        for (const protocol::Accelerator* accelerator : protocol::accelerators)
            names.push_back(accelerator->name);
        return fail(refused_value(text, fmt::format("an accelerator: {}{}", fmt::join(names, ", "),
                                                    did_you_mean(text, names))));
    }
    config.accelerator = found;
    return {};
}

Result<void> set_basis_check(Config& config, std::string_view text)
{
    return set_choice<BasisCheck, 3>(config.basis_check, text, {"off", "warn", "reject"},
                                     "off, warn or reject");
}

Result<void> set_replies(Config& config, std::string_view text)
{
    return set_choice<Replies, 3>(config.replies, text, {"all", "errors", "none"},
                                  "all, errors or none");
}

Result<void> set_require_checksum(Config& config, std::string_view text)
{
    return set_choice<bool, 2>(config.require_checksum, text, {"false", "true"}, "true or false");
}

Result<void> set_emulated_form(Config& config, std::string_view text)
{
    return set_choice<emulation::BlockForm, 2>(config.emulated.form, text, {"extended", "bare"},
                                               "extended or bare");
}

Result<void> set_emulated_size(Config& config, std::string_view text)
{
    if (text == "auto") {
        config.emulated.size = {};
        return {};
    }
    const auto size = protocol::parse_size(text, {UINT16_MAX, UINT16_MAX});
    if (!size)
        return fail(refused_value(text, "auto or a size such as 640x480"));
    config.emulated.size = *size;
    return {};
}

Result<void> set_emulated_threads(Config& config, std::string_view text)
{
    const auto threads = number(text);
    if (!threads || *threads > 256)
        return fail(refused_value(text, "a number of threads, 0 (one for each processor) to 256"));
    config.emulated.threads = *threads;
    return {};
}

constexpr std::string_view default_name = protocol::default_accelerator.name;

// Laid out by hand: one row a setting.
// clang-format off
constexpr std::array settings_table = {
    Setting{"accelerator",      "NAME",                       default_name,               "the accelerator of a block that does not tell its kind, and of the emulated one", set_accelerator},
    Setting{"registers",        registers_values,             "auto",                     "the register block; auto is the UIO device named raymarch; on a machine that is no Zynq and has none, the block is emulated", set_registers},
    Setting{"serial",           serial_values,                "/dev/ttyPS0@115200",       "the serial host; pty makes a pseudo-terminal and a link to it", set_serial},
    Setting{"gpio",             "lines|none",                 "lines",                    "buttons, switches and LEDs; lines are those of the table gpio_lines", set_gpio},
    Setting{"gpio_debounce",    "MS",                         "10",                       "milliseconds that a button's level has to last before it counts", set_gpio_debounce},
    Setting{"gpio_orbit_rate",  "N",                          "20",                       "steps a second while orbit_left or orbit_right is held", set_gpio_orbit_rate},
    Setting{"gpio_turn_rate",   "N",                          "5",                        "steps a second while the switch turn is on", set_gpio_turn_rate},
    Setting{"state",            "FILE|none",                  "/var/lib/raymarchd/state", "where the state is kept over a restart", set_state},
    Setting{"control",          "SOCKET|none",                "/run/raymarchd/control",   "local socket that speaks the serial protocol", set_control},
    Setting{"preview",          "FILE.png|none",              "none",                     "the latest picture of the emulated accelerator, replaced whole", set_preview},
    Setting{"sysfs_root",       "PATH",                       "/sys",                     "the folder used as /sys, for tests without a kernel; UIO devices are in the folder dev beside it", set_sysfs_root},
    Setting{"log_level",        "error|warning|notice|info|debug", "notice",              "what is logged", set_log_level},
    Setting{"basis_check",      "off|warn|reject",            "warn",                     "what is done about a camera basis that no camera has", set_basis_check},
    Setting{"replies",          "all|errors|none",            "all",                      "which replies are sent", set_replies},
    Setting{"require_checksum", "true|false",                 "false",                    "whether every line must carry *HH", set_require_checksum},
    Setting{"emulated_form",    "extended|bare",              "extended",                 "bare: the emulated block has the parameter words only, as the source's", set_emulated_form},
    Setting{"emulated_size",    "auto|WxH",                   "auto",                     "size of the emulated accelerator's picture; auto is what its source draws", set_emulated_size},
    Setting{"emulated_threads", "N",                          "0",                        "threads that draw; 0 is one for each processor", set_emulated_threads},
};
// clang-format on

} // namespace

std::span<const Setting> settings() noexcept
{
    return settings_table;
}

} // namespace raymarch::daemon
