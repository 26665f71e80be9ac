// SPDX-License-Identifier: MIT
/// @file
/// TABLE: every setting of the service, with its default; the command line, the configuration file
/// and the manual page are made from it.
#pragma once

#include "base/log.hpp"
#include "base/result.hpp"
#include "emulation/emulated_block.hpp"
#include "protocol/parameters.hpp"

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <variant>

namespace raymarch::daemon
{

/// Where the register block is.
struct AutoRegisters
{}; ///< the UIO device named raymarch where there is one, else emulated
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

/// All defaults.
[[nodiscard]] Config default_config();

/// Applies one setting. Errors: Config, naming what is allowed.
[[nodiscard]] Result<void> set(Config& config, std::string_view name, std::string_view text);

/// What one setting cannot see of the others. Errors: Config.
[[nodiscard]] Result<void> validate(const Config& config);

/// Applies a TOML file. Errors: Config, with file and line; an unknown key is one.
[[nodiscard]] Result<void> read_config_file(Config& config, const std::string& path);

/// The file that is read when it exists and no other is named.
inline constexpr const char* default_config_path = "/etc/raymarchd.toml";

} // namespace raymarch::daemon
