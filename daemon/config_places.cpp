// SPDX-License-Identifier: MIT
/// @file
/// The settings `registers` and `serial`, from text and to text.
#include "daemon/setting_values.hpp"
#include "drivers/tty_name.hpp"

#include <fmt/format.h>

#include <optional>
#include <string>

namespace raymarch::daemon
{
namespace
{

/// Returns the text after `prefix`, or nothing if it is empty or `prefix` is missing.
std::optional<std::string> behind(std::string_view text, std::string_view prefix)
{
    if (!text.starts_with(prefix) || text.size() == prefix.size())
        return std::nullopt;
    return std::string(text.substr(prefix.size()));
}

} // namespace

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
        return fail(refused_value(text, registers_values));
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
        return fail(refused_value(text, serial_values));
    }
    return {};
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

} // namespace raymarch::daemon
