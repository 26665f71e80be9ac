// SPDX-License-Identifier: MIT
/// @file
/// TABLE: every setting of the service, with its default; the command line, the configuration file
/// and the manual page are made from it.
#pragma once

#include "base/log.hpp"
#include "base/result.hpp"
#include "drivers/line_spec.hpp"
#include "emulation/emulated_block.hpp"
#include "protocol/parameters.hpp"

#include <chrono>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace raymarch::daemon
{

/// Where the register block is.
struct AutoRegisters
{}; ///< the UIO device named raymarch; without one, and on no Zynq, the emulated block
struct UioNode
{
    std::string path;
};
struct UioName
{
    std::string name;
};
struct RegisterFile
{
    std::string path;
};
struct EmulatedRegisters
{};
using RegistersWhere =
    std::variant<AutoRegisters, UioNode, UioName, RegisterFile, EmulatedRegisters>;

/// Where the serial host is.
struct NoSerial
{};
struct SerialDevice
{
    std::string path;
    unsigned baud;
};
struct PseudoTerminalLink
{
    std::string link;
};
using SerialWhere = std::variant<NoSerial, SerialDevice, PseudoTerminalLink>;

enum class BasisCheck : std::uint8_t { Off, Warn, Reject };
enum class Replies : std::uint8_t { All, Errors, None };

/// Buttons, switches and LEDs.
struct Gpio
{
    bool used = true;
    std::chrono::milliseconds debounce{};
    unsigned orbit_rate = 0; ///< steps a second while a button of orbit is held
    unsigned turn_rate = 0;  ///< the same of the switch `turn`
    std::vector<std::optional<drivers::LineSpec>> lines; ///< in the order of actions()
};

struct Config
{
    RegistersWhere registers;
    SerialWhere serial;
    std::string state;   ///< empty: none
    std::string control; ///< empty: none
    std::string preview; ///< empty: none
    std::string sysfs_root;
    log::Level log_level = log::Level::Notice;
    const protocol::Accelerator* accelerator = nullptr;
    BasisCheck basis_check = BasisCheck::Warn;
    Replies replies = Replies::All;
    bool require_checksum = false;
    emulation::EmulatedOptions emulated;
    Gpio gpio;
};

/// One setting. `name` is its key in the file and, with dashes, its option on the command line.
struct Setting
{
    std::string_view name;
    std::string_view value;   ///< what it takes, for help
    std::string_view initial; ///< the default
    std::string_view meaning;
    Result<void> (*set)(Config& config, std::string_view text);
};
[[nodiscard]] std::span<const Setting> settings() noexcept;

/// Writes a value as the settings `registers` and `serial` take it.
[[nodiscard]] std::string to_text(const RegistersWhere& where);
[[nodiscard]] std::string to_text(const SerialWhere& where);

/// Makes a configuration with all defaults.
[[nodiscard]] Config default_config();

/// Applies one setting. Errors: Config, naming what is allowed.
[[nodiscard]] Result<void> set(Config& config, std::string_view name, std::string_view text);

/// The table of the file that gives the actions of daemon/actions.hpp their lines.
inline constexpr std::string_view lines_table = "gpio_lines";

/// What each of them takes, besides `none`.
inline constexpr std::string_view line_values = drivers::line_spec_syntax;

/// Gives one action its line; `none` takes it away. Errors: Config, naming what is allowed.
[[nodiscard]] Result<void> set_line(Config& config, std::string_view action, std::string_view text);

/// Checks settings that depend on one another. Errors: Config.
[[nodiscard]] Result<void> validate(const Config& config);

/// Applies a TOML file. Errors: Config, with file and line; an unknown key is one.
[[nodiscard]] Result<void> read_config_file(Config& config, const std::string& path);

/// Does the same with the text of a file; `path` is for messages.
[[nodiscard]] Result<void> read_config_text(Config& config, std::string_view text,
                                            const std::string& path);

/// The file that is read when it exists and no other is named.
inline constexpr const char* default_config_path = "/etc/raymarchd.toml";

} // namespace raymarch::daemon
