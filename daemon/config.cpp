// SPDX-License-Identifier: MIT
#include "daemon/config.hpp"

#include "base/nearest.hpp"
#include "daemon/actions.hpp"
#include "daemon/movement.hpp"
#include "drivers/tty_name.hpp"
#include "drivers/unix_socket.hpp"
#include "protocol/accelerators.hpp"
#include "protocol/picture_size.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <array>
#include <charconv>
#include <optional>
#include <vector>

namespace raymarch::daemon
{
namespace
{

Error refuse(std::string_view text, std::string_view allowed)
{
    return plain_error(ErrorKind::Config, fmt::format("'{}' is not {}", text, allowed));
}

std::optional<unsigned> number(std::string_view text)
{
    unsigned value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc{} || end != text.data() + text.size())
        return std::nullopt;
    return value;
}

/// What follows `prefix`, if it is there and something follows it.
std::optional<std::string> behind(std::string_view text, std::string_view prefix)
{
    if (!text.starts_with(prefix) || text.size() == prefix.size())
        return std::nullopt;
    return std::string(text.substr(prefix.size()));
}

constexpr std::string_view registers_values = "auto|uio:/dev/uioN|uio-name:NAME|file:PATH|emulated";
constexpr std::string_view serial_values = "/dev/TTY[@BAUD]|pty:LINK|none";

Result<void> set_registers(Config& config, std::string_view text)
{
    if (text == "auto")
        config.registers = AutoRegisters{};
    else if (text == "emulated")
        config.registers = EmulatedRegisters{};
    else if (const auto name = behind(text, "uio-name:"))
        config.registers = UioName{*name};
    else if (const auto device = behind(text, "uio:"))
        config.registers = UioNode{*device};
    else if (const auto path = behind(text, "file:"))
        config.registers = RegisterFile{*path};
    else
        return fail(refuse(text, registers_values));
    return {};
}

Result<void> set_serial(Config& config, std::string_view text)
{
    if (text == "none") {
        config.serial = NoSerial{};
    } else if (const auto link = behind(text, "pty:")) {
        config.serial = PseudoTerminalLink{*link};
    } else if (text.starts_with('/')) {
        const auto name = drivers::parse_tty_name(text);
        if (!name)
            return fail(plain_error(ErrorKind::Config, name.error().message));
        config.serial = SerialDevice{name->path, name->baud};
    } else {
        return fail(refuse(text, serial_values));
    }
    return {};
}

/// One of `names` to the enumerator of the same position.
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
    return fail(refuse(text, allowed));
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
        return fail(refuse(text, fmt::format("a number of milliseconds, 0 to {}", longest)));
    config.gpio.debounce = std::chrono::milliseconds(*milliseconds);
    return {};
}

Result<void> set_rate(unsigned& target, std::string_view text)
{
    const auto rate = number(text);
    if (!rate || *rate < 1 || *rate > most_rate)
        return fail(refuse(text, fmt::format("a number of steps a second, 1 to {}", most_rate)));
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

/// A path into `target`; `none` empties it.
Result<void> set_path(std::string& target, std::string_view text)
{
    if (text.empty())
        return fail(refuse(text, "a path or none"));
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
        return fail(
            refuse(text, fmt::format("a path of at most {} bytes", drivers::max_socket_path)));
    return set_path(config.control, text);
}

Result<void> set_preview(Config& config, std::string_view text)
{
    if (text != "none" && !text.ends_with(".png"))
        return fail(refuse(text, "FILE.png or none"));
    return set_path(config.preview, text);
}

Result<void> set_sysfs_root(Config& config, std::string_view text)
{
    if (!text.starts_with('/'))
        return fail(refuse(text, "a path from / on"));
    config.sysfs_root = text;
    return {};
}

Result<void> set_log_level(Config& config, std::string_view text)
{
    const auto level = log::level_named(text);
    if (!level)
        return fail(refuse(text, "error, warning, notice, info or debug"));
    config.log_level = *level;
    return {};
}

Result<void> set_accelerator(Config& config, std::string_view text)
{
    config.accelerator = protocol::find_accelerator(text);
    if (config.accelerator == nullptr) {
        std::vector<std::string_view> names;
        for (const protocol::Accelerator* accelerator : protocol::accelerators)
            names.push_back(accelerator->name);
        return fail(refuse(text, fmt::format("an accelerator: {}{}", fmt::join(names, ", "),
                                             did_you_mean(text, names))));
    }
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
        return fail(refuse(text, "auto or a size such as 640x480"));
    config.emulated.size = *size;
    return {};
}

Result<void> set_emulated_threads(Config& config, std::string_view text)
{
    const auto threads = number(text);
    if (!threads || *threads > 256)
        return fail(refuse(text, "a number of threads, 0 (one for each processor) to 256"));
    config.emulated.threads = *threads;
    return {};
}

constexpr std::string_view default_name = protocol::default_accelerator.name;

// Laid out by hand: one row a setting.
// clang-format off
constexpr std::array settings_table = {
    Setting{"accelerator",      "NAME",                       default_name,               "the accelerator of a block that does not tell its kind, and of the emulated one", set_accelerator},
    Setting{"registers",        registers_values,             "auto",                     "the register block; auto is the UIO device named raymarch on a Zynq and where there is one, else emulated", set_registers},
    Setting{"serial",           serial_values,                "/dev/ttyPS0@115200",       "the serial host; pty makes a pseudo-terminal and a link to it", set_serial},
    Setting{"gpio",             "lines|none",                 "lines",                    "buttons, switches and LEDs; lines are those of the table gpio_lines", set_gpio},
    Setting{"gpio_debounce",    "MS",                         "10",                       "milliseconds that a button's level has to last before it counts", set_gpio_debounce},
    Setting{"gpio_orbit_rate",  "N",                          "20",                       "steps a second while orbit_left or orbit_right is held", set_gpio_orbit_rate},
    Setting{"gpio_turn_rate",   "N",                          "5",                        "steps a second while the switch turn is on", set_gpio_turn_rate},
    Setting{"state",            "FILE|none",                  "/var/lib/raymarchd/state", "where the state is kept over a restart", set_state},
    Setting{"control",          "SOCKET|none",                "/run/raymarchd/control",   "local socket that speaks the serial protocol", set_control},
    Setting{"preview",          "FILE.png|none",              "none",                     "the latest picture of the emulated accelerator, replaced whole", set_preview},
    Setting{"sysfs_root",       "PATH",                       "/sys",                     "what stands in for /sys, so that a folder can play the kernel; UIO devices are in the dev beside it", set_sysfs_root},
    Setting{"log_level",        "error|warning|notice|info|debug", "notice",              "what is logged", set_log_level},
    Setting{"basis_check",      "off|warn|reject",            "warn",                     "what is done about a camera basis that no camera has", set_basis_check},
    Setting{"replies",          "all|errors|none",            "all",                      "which replies are sent", set_replies},
    Setting{"require_checksum", "true|false",                 "false",                    "whether every line must carry *HH", set_require_checksum},
    Setting{"emulated_form",    "extended|bare",              "extended",                 "bare: the emulated block has the parameter words only, as the source's", set_emulated_form},
    Setting{"emulated_size",    "auto|WxH",                   "auto",                     "size of the emulated accelerator's picture; auto is what its source draws", set_emulated_size},
    Setting{"emulated_threads", "N",                          "0",                        "threads that draw; 0 is one for each processor", set_emulated_threads},
};
// clang-format on

Error no_setting(std::string_view name)
{
    std::vector<std::string_view> names;
    for (const Setting& setting : settings_table)
        names.push_back(setting.name);
    return plain_error(ErrorKind::Config,
                       fmt::format("there is no setting '{}'{}", name, did_you_mean(name, names)));
}

} // namespace

std::span<const Setting> settings() noexcept
{
    return settings_table;
}

std::string to_text(const RegistersWhere& where)
{
    struct Writer
    {
        std::string operator()(const AutoRegisters&) const { return "auto"; }
        std::string operator()(const UioNode& uio) const { return "uio:" + uio.path; }
        std::string operator()(const UioName& uio) const { return "uio-name:" + uio.name; }
        std::string operator()(const RegisterFile& file) const { return "file:" + file.path; }
        std::string operator()(const EmulatedRegisters&) const { return "emulated"; }
    };
    return std::visit(Writer{}, where);
}

std::string to_text(const SerialWhere& where)
{
    struct Writer
    {
        std::string operator()(const NoSerial&) const { return "none"; }
        std::string operator()(const SerialDevice& device) const
        {
            return fmt::format("{}@{}", device.path, device.baud);
        }
        std::string operator()(const PseudoTerminalLink& terminal) const
        {
            return "pty:" + terminal.link;
        }
    };
    return std::visit(Writer{}, where);
}

Config default_config()
{
    Config config;
    for (const Setting& setting : settings_table)
        static_cast<void>(setting.set(config, setting.initial)); // a test proves that each is taken
    for (const Action& action : actions())
        config.gpio.lines.push_back(drivers::parse_line_spec(action.line)); // and that each is one
    return config;
}

Result<void> set(Config& config, std::string_view name, std::string_view text)
{
    for (const Setting& setting : settings_table) {
        if (setting.name != name)
            continue;
        auto result = setting.set(config, text);
        if (!result)
            result.error().message = fmt::format("{}: {}", name, result.error().message);
        return result;
    }
    return fail(no_setting(name));
}

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
            Error error = refuse(text, allowed);
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

namespace
{

/// A line can be requested once.
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

} // namespace

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
