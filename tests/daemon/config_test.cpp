// SPDX-License-Identifier: MIT
#include "daemon/config.hpp"

#include "daemon/actions.hpp"
#include "daemon/options.hpp"
#include "protocol/accelerators.hpp"
#include "tests/fakes/temporary_folder.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace raymarch::daemon
{
namespace
{

TEST(Config, EveryDefaultIsAccepted)
{
    Config config;
    std::set<std::string_view> names;
    for (const Setting& setting : settings()) {
        const auto result = set(config, setting.name, setting.initial);
        EXPECT_TRUE(result) << setting.name << ": " << result.error().message;
        EXPECT_TRUE(names.insert(setting.name).second) << setting.name;
        EXPECT_FALSE(setting.meaning.empty() || setting.value.empty()) << setting.name;
    }
}

TEST(Config, TheDefaults)
{
    const Config config = default_config();
    EXPECT_TRUE(std::holds_alternative<AutoRegisters>(config.registers));
    ASSERT_TRUE(std::holds_alternative<SerialDevice>(config.serial));
    EXPECT_EQ(std::get<SerialDevice>(config.serial).path, "/dev/ttyPS0");
    EXPECT_EQ(std::get<SerialDevice>(config.serial).baud, 115'200U);
    EXPECT_EQ(config.state, "/var/lib/raymarchd/state");
    EXPECT_EQ(config.control, "/run/raymarchd/control");
    EXPECT_EQ(config.preview, "");
    EXPECT_EQ(config.log_level, log::Level::Notice);
    EXPECT_EQ(config.accelerator, &protocol::marcher::description);
    EXPECT_EQ(config.basis_check, BasisCheck::Warn);
    EXPECT_EQ(config.replies, Replies::All);
    EXPECT_FALSE(config.require_checksum);
    EXPECT_EQ(config.emulated.form, emulation::BlockForm::Extended);
    EXPECT_EQ(config.emulated.size, protocol::PictureSize{}); // what the accelerator's source draws
    EXPECT_EQ(config.emulated.threads, 0U);
    EXPECT_TRUE(config.gpio.used);
    EXPECT_EQ(config.gpio.debounce, std::chrono::milliseconds{10});
    EXPECT_EQ(config.gpio.orbit_rate, 20U);
    EXPECT_EQ(config.gpio.turn_rate, 5U);
}

Config with(std::string_view name, std::string_view text)
{
    Config config = default_config();
    const auto result = set(config, name, text);
    EXPECT_TRUE(result) << name << '=' << text;
    return config;
}

TEST(Config, PlacesOfRegisters)
{
    EXPECT_EQ(std::get<UioNode>(with("registers", "uio:/dev/uio3").registers).path, "/dev/uio3");
    EXPECT_EQ(std::get<UioName>(with("registers", "uio-name:block").registers).name, "block");
    EXPECT_EQ(std::get<RegisterFile>(with("registers", "file:/tmp/a b").registers).path,
              "/tmp/a b");
    EXPECT_TRUE(std::holds_alternative<EmulatedRegisters>(with("registers", "emulated").registers));
}

TEST(Config, PlacesOfSerialHosts)
{
    const Config device = with("serial", "/dev/ttyUSB0@9600");
    EXPECT_EQ(std::get<SerialDevice>(device.serial).path, "/dev/ttyUSB0");
    EXPECT_EQ(std::get<SerialDevice>(device.serial).baud, 9600U);
    EXPECT_EQ(std::get<SerialDevice>(with("serial", "/dev/tty@x@1200").serial).path, "/dev/tty@x");
    const Config home = with("serial", "/home/jane@corp.example/tty");
    EXPECT_EQ(std::get<SerialDevice>(home.serial).path, "/home/jane@corp.example/tty");
    EXPECT_EQ(std::get<SerialDevice>(home.serial).baud, 115'200U);
    EXPECT_EQ(std::get<PseudoTerminalLink>(with("serial", "pty:link").serial).link, "link");
    EXPECT_TRUE(std::holds_alternative<NoSerial>(with("serial", "none").serial));
}

TEST(Config, TheOtherValues)
{
    EXPECT_EQ(with("state", "none").state, "");
    EXPECT_EQ(with("control", "none").control, "");
    EXPECT_EQ(with("preview", "a.png").preview, "a.png");
    EXPECT_EQ(with("log_level", "debug").log_level, log::Level::Debug);
    EXPECT_EQ(with("basis_check", "off").basis_check, BasisCheck::Off);
    EXPECT_EQ(with("basis_check", "reject").basis_check, BasisCheck::Reject);
    EXPECT_EQ(with("replies", "errors").replies, Replies::Errors);
    EXPECT_EQ(with("replies", "none").replies, Replies::None);
    EXPECT_TRUE(with("require_checksum", "true").require_checksum);
    EXPECT_EQ(with("emulated_form", "bare").emulated.form, emulation::BlockForm::Bare);
    EXPECT_EQ(with("emulated_size", "1920x1080").emulated.size,
              (protocol::PictureSize{1920, 1080}));
    EXPECT_EQ(with("emulated_threads", "256").emulated.threads, 256U);
    EXPECT_FALSE(with("gpio", "none").gpio.used);
    EXPECT_EQ(with("gpio_debounce", "0").gpio.debounce, std::chrono::milliseconds{0});
    EXPECT_EQ(with("gpio_orbit_rate", "60").gpio.orbit_rate, 60U);
    EXPECT_EQ(with("gpio_turn_rate", "1").gpio.turn_rate, 1U);
}

struct RefusalRow
{
    std::string_view name;
    std::string_view text;
    std::string_view allowed; ///< what the message must hold
};

constexpr std::array refusals = {
    RefusalRow{"registers", "uio", "uio:/dev/uioN"},
    RefusalRow{"registers", "uio:", "uio:/dev/uioN"},
    RefusalRow{"registers", "uio-name:", "uio-name:NAME"},
    RefusalRow{"registers", "file:", "file:PATH"},
    RefusalRow{"registers", "", "emulated"},
    RefusalRow{"registers", "Auto", "auto"},
    RefusalRow{"serial", "ttyPS0", "/dev/TTY[@BAUD]"},
    RefusalRow{"serial", "/dev/ttyPS0@", "/dev/TTY[@BAUD]"},
    RefusalRow{"serial", "/dev/ttyPS0@fast", "/dev/TTY[@BAUD]"},
    RefusalRow{"serial", "/dev/ttyPS0@-1", "/dev/TTY[@BAUD]"},
    RefusalRow{"serial", "/dev/ttyPS0@115200x", "/dev/TTY[@BAUD]"},
    RefusalRow{"serial", "/dev/ttyUSB0 @115200", "a blank"},
    RefusalRow{"serial", "/dev/ttyUSB0@ 115200", "/dev/TTY[@BAUD]"},
    RefusalRow{"serial", "/dev/ttyUSB0 ", "a blank"},
    RefusalRow{"serial", "pty:", "pty:LINK"},
    RefusalRow{"serial", "", "none"},
    RefusalRow{"gpio", "gpiochip0", "lines or none"},
    RefusalRow{"gpio_debounce", "1001", "0 to 1000"},
    RefusalRow{"gpio_debounce", "-1", "0 to 1000"},
    RefusalRow{"gpio_debounce", "5ms", "milliseconds"},
    RefusalRow{"gpio_orbit_rate", "0", "1 to 60"},
    RefusalRow{"gpio_orbit_rate", "61", "1 to 60"},
    RefusalRow{"gpio_turn_rate", "slow", "steps a second"},
    RefusalRow{"preview", "picture.jpg", "FILE.png"},
    RefusalRow{"log_level", "loud", "error, warning, notice, info or debug"},
    RefusalRow{"accelerator", "teapot", "marcher"},
    RefusalRow{"basis_check", "on", "off, warn or reject"},
    RefusalRow{"replies", "some", "all, errors or none"},
    RefusalRow{"require_checksum", "yes", "true or false"},
    RefusalRow{"emulated_form", "full", "extended or bare"},
    RefusalRow{"emulated_size", "0x480", "auto or a size such as 640x480"},
    RefusalRow{"emulated_size", "large", "auto or a size such as 640x480"},
    RefusalRow{"emulated_threads", "257", "256"},
    RefusalRow{"emulated_threads", "-1", "256"},
    RefusalRow{"emulated_threads", "two", "256"},
};

TEST(Config, EveryRefusalNamesTheSettingTheTextAndWhatIsAllowed)
{
    for (const RefusalRow& row : refusals) {
        Config config = default_config();
        const auto result = set(config, row.name, row.text);
        ASSERT_FALSE(result) << row.name << '=' << row.text;
        const Error& error = result.error();
        EXPECT_EQ(error.kind, ErrorKind::Config);
        EXPECT_TRUE(error.message.starts_with(std::string(row.name) + ": ")) << error.message;
        EXPECT_NE(error.message.find("'" + std::string(row.text) + "'"), std::string::npos)
            << error.message;
        EXPECT_NE(error.message.find(row.allowed), std::string::npos) << error.message;
    }
}

TEST(Config, ABaudRateThatNoTerminalHasIsRefusedAtOnce)
{
    Config config = default_config();
    const auto result = set(config, "serial", "/dev/ttyPS0@115201");
    ASSERT_FALSE(result);
    EXPECT_TRUE(result.error().message.starts_with("serial: '115201' is not"))
        << result.error().message;
    EXPECT_NE(result.error().message.find(" 115200 "), std::string::npos);
}

TEST(Config, APathThatNoSocketCanHaveIsRefusedAtOnce)
{
    Config config = default_config();
    EXPECT_TRUE(set(config, "control", "/" + std::string(106, 'x')));
    const auto result = set(config, "control", "/" + std::string(107, 'x')); // 108 with its end
    ASSERT_FALSE(result);
    EXPECT_NE(result.error().message.find("107"), std::string::npos) << result.error().message;
}

TEST(Config, TheSizeIsJudgedByTheAcceleratorWhicheverIsNamedFirst)
{
    Config config = with("emulated_size", "1920x1080");
    EXPECT_TRUE(validate(config));
    ASSERT_TRUE(set(config, "accelerator", "marcher"));
    EXPECT_EQ(config.emulated.size, (protocol::PictureSize{1920, 1080}));
    for (const std::string_view size : {"1921x1080", "1920x1081"}) {
        const auto result = validate(with("emulated_size", size));
        ASSERT_FALSE(result) << size;
        EXPECT_EQ(result.error().kind, ErrorKind::Config);
        EXPECT_NE(result.error().message.find("1920x1080"), std::string::npos);
    }
    EXPECT_TRUE(validate(default_config()));
}

const std::optional<drivers::LineSpec>& line_of(const Config& config, std::string_view name)
{
    const auto row = std::ranges::find(actions(), name, &Action::name);
    return config.gpio.lines.at(static_cast<std::size_t>(row - actions().begin()));
}

TEST(Config, ActionsGetLinesAndLoseThem)
{
    Config config = default_config();
    ASSERT_TRUE(set_line(config, "reset", "keys:4,active-low,pull-up"));
    EXPECT_EQ(line_of(config, "reset"), drivers::parse_line_spec("keys:4,active-low,pull-up"));
    ASSERT_TRUE(set_line(config, "reset", "GPIO 17|'J8:3'"));
    EXPECT_EQ(line_of(config, "reset")->places.at(0).name, "GPIO 17");
    EXPECT_EQ(line_of(config, "reset")->places.at(1).name, "J8:3");
    ASSERT_TRUE(set_line(config, "lock", "'none'"));
    EXPECT_TRUE(line_of(config, "lock"));
    ASSERT_TRUE(set_line(config, "lock", "none"));
    EXPECT_FALSE(line_of(config, "lock"));
    EXPECT_TRUE(line_of(config, "turn"));
}

struct LineRefusalRow
{
    std::string_view action;
    std::string_view text;
    std::string_view message; ///< what it must hold
};
constexpr std::array line_refusals = {
    LineRefusalRow{"rest", "btn0",
                   "gpio_lines: unknown action 'rest'; there are reset, next_scene, "},
    LineRefusalRow{"rest", "btn0", "; did you mean 'reset'?"},
    LineRefusalRow{"", "btn0", "unknown action ''"},
    LineRefusalRow{"reset", "", "gpio_lines.reset: '' is not none or NAME or CHIP:OFFSET"},
    LineRefusalRow{"reset", "btn0,loud", "'btn0,loud' is not none or NAME or CHIP:OFFSET"},
    LineRefusalRow{"running", "led3,pull-up",
                   "gpio_lines.running: 'led3,pull-up' is not for an LED"},
};

TEST(Config, EveryRefusalOfALineNamesWhatIsAllowed)
{
    for (const LineRefusalRow& row : line_refusals) {
        Config config = default_config();
        const auto result = set_line(config, row.action, row.text);
        ASSERT_FALSE(result) << row.action << '=' << row.text;
        EXPECT_EQ(result.error().kind, ErrorKind::Config);
        EXPECT_NE(result.error().message.find(row.message), std::string::npos)
            << result.error().message;
    }
}

TEST(Config, PlacesAreWrittenAsTheyAreSet)
{
    Config config = default_config();
    for (const std::string_view text :
         {"auto", "uio:/dev/uio3", "uio-name:raymarch", "file:a/b c", "emulated"}) {
        ASSERT_TRUE(set(config, "registers", text)) << text;
        EXPECT_EQ(to_text(config.registers), text);
    }
    for (const std::string_view text : {"none", "pty:a/b c", "/dev/ttyPS0@9600"}) {
        ASSERT_TRUE(set(config, "serial", text)) << text;
        EXPECT_EQ(to_text(config.serial), text);
    }
    ASSERT_TRUE(set(config, "serial", "/dev/ttyPS0"));
    EXPECT_EQ(to_text(config.serial), "/dev/ttyPS0@115200");
}

TEST(Config, ALineHasOneAction)
{
    Config config = default_config();
    ASSERT_TRUE(set_line(config, "turn", "btn0"));
    const auto result = validate(config);
    ASSERT_FALSE(result);
    EXPECT_EQ(result.error().message, "gpio_lines: reset and turn are both btn0");
    ASSERT_TRUE(set_line(config, "reset", "none"));
    EXPECT_TRUE(validate(config));
}

TEST(Config, AnUnknownSettingIsRefused)
{
    Config config = default_config();
    const auto result = set(config, "colour", "red");
    ASSERT_FALSE(result);
    EXPECT_NE(result.error().message.find("'colour'"), std::string::npos);
}

class ConfigFile : public testing::Test
{
  protected:
    Result<void> read(std::string_view text)
    {
        test::write_text(path, text);
        return read_config_file(config, path);
    }
    /// Fails, at this line of the file, with this in the message.
    void expect_error(std::string_view text, int line, std::string_view part)
    {
        const auto result = read(text);
        ASSERT_FALSE(result) << text;
        EXPECT_EQ(result.error().kind, ErrorKind::Config);
        EXPECT_TRUE(result.error().message.starts_with(path + ":" + std::to_string(line) + ": "))
            << result.error().message;
        EXPECT_NE(result.error().message.find(part), std::string::npos) << result.error().message;
    }

    test::TemporaryFolder folder;
    std::string path = folder / "raymarchd.toml";
    Config config = default_config();
};

TEST_F(ConfigFile, StringsNumbersAndBooleans)
{
    ASSERT_TRUE(read("# comment\nserial = \"pty:link\"\nrequire_checksum = true\n"
                     "emulated_threads = 3\nemulated_size = \"8x6\"\naccelerator = 'marcher'\n"));
    EXPECT_EQ(std::get<PseudoTerminalLink>(config.serial).link, "link");
    EXPECT_TRUE(config.require_checksum);
    EXPECT_EQ(config.emulated.threads, 3U);
    EXPECT_EQ(config.emulated.size, (protocol::PictureSize{8, 6}));
    EXPECT_EQ(config.replies, Replies::All); // what is not named stays
}

/// Each of them would end the program: toml++ asserts what it should report.
TEST_F(ConfigFile, WhatTheParserFailsOverIsRefused)
{
    for (const std::string_view header : {"[", "[[", "[!", "[[!", "[.]", "[[[x]]]", "[\xC3\xA9]",
                                          "[ ", "[ \t", "[[ =", "  [#", "[\r", "[ [gpio_lines]"})
        for (const std::string_view end : {"", "\n", "\nreset = \"btn0\"\n"})
            expect_error("# first\n" + std::string(header) + std::string(end), 2,
                         "header of a table");
    for (const char control : {'\0', '\x01', '\x0B', '\x0C', '\x1B', '\x7F'}) {
        const std::string sign(1, control);
        for (const std::string& text : {sign, "serial" + sign + " = \"none\"", "a" + sign + "[x]",
                                        "[x" + sign + "]", "serial = \"" + sign + "\"", "#" + sign})
            expect_error("\n" + text, 2, "control character");
    }
    for (const std::string_view text :
         {"gr\xC3\xB6\xC3\x9F = 1", "serial = \"none\"\xC2\xA0", "\xEF\xBB\xBF", "\xC2\xA0", "\xFF",
          "serial = \"a\\\"\" \xC3\xB6"})
        expect_error("\"a\" = \"\"\"\n\"\"\"\n" + std::string(text) + "\n", 3, "beyond ASCII");
    EXPECT_TRUE(read("# gr\xC3\xB6\xC3\x9F\nserial = \"pty:gr\xC3\xB6\xC3\x9F\" # \xE2\x82\xAC\n"
                     "state = 'gr\xC3\xB6\xC3\x9F'\ncontrol = \"\"\"a[!\n[!\"\"\"\n"))
        << "in strings and comments anything may stand";
    EXPECT_TRUE(read("\xEF\xBB\xBFserial = \"none\"\n")) << "as some editors begin a file";
    EXPECT_TRUE(read(" [ gpio_lines ] # buttons\r\n\treset = \"btn0\"\r\n"));
    EXPECT_TRUE(read("[\"gpio_lines\"]\n"));
    expect_error("[]\n", 1, "");
}

TEST_F(ConfigFile, TheTableOfLines)
{
    ASSERT_TRUE(read("gpio_orbit_rate = 30\n[gpio_lines]\nreset = \"none\"\n"
                     "heartbeat = \"/dev/gpiochip0:7,active-low\"\n"));
    EXPECT_EQ(config.gpio.orbit_rate, 30U);
    EXPECT_FALSE(line_of(config, "reset"));
    EXPECT_EQ(line_of(config, "heartbeat"),
              drivers::parse_line_spec("/dev/gpiochip0:7,active-low"));
    EXPECT_TRUE(line_of(config, "turn")); // what is not named stays
    expect_error("[gpio_lines]\n\nbuzzer = \"x\"\n", 3, "unknown action 'buzzer'; there are reset");
    expect_error("[gpio_lines]\nreset = [1]\n", 2, "reset");
    expect_error("gpio_lines = \"btn0\"\n", 1, "[gpio_lines]");
}

TEST_F(ConfigFile, AnEmptyFileIsOne)
{
    EXPECT_TRUE(read(""));
}

TEST_F(ConfigFile, ErrorsNameFileAndLine)
{
    expect_error("serial = \"none\"\n\ncolour = \"red\"\n", 3, "colour");
    expect_error("\nreplies = \"some\"\n", 2, "all, errors or none");
    expect_error("emulated_threads = 1.5\n", 1, "emulated_threads");
    expect_error("\n\n[serial]\ndevice = \"/dev/ttyPS0\"\n", 3, "serial");
    expect_error("replies = [\"all\"]\n", 1, "replies");
    expect_error("serial = \"none\"\nreplies = \n", 2, "");
    expect_error("replies = \"all\"\nreplies = \"all\"\n", 2, "replies");
}

TEST_F(ConfigFile, ATableThatIsNotThereIsCalledOne)
{
    expect_error("replies = \"all\"\n[gpio]\nreset = \"btn0\"\n", 2,
                 "there is no table [gpio]: gpio is a setting, gpio = VALUE; "
                 "the only table is [gpio_lines]");
    expect_error("[lines]\nreset = \"btn0\"\n", 1,
                 "there is no table [lines] and no setting 'lines'; "
                 "the only table is [gpio_lines]");
    expect_error("gpio.lines = 1\n", 1, "there is no table [gpio]");
    expect_error("[gpio_lines]\n[gpio_lines.reset]\nline = 4\n", 2,
                 "gpio_lines.reset takes a string, not a table");
    expect_error("[gpio_lines.buzzer]\nline = 4\n", 1, "unknown action 'buzzer'");
    expect_error("[[gpio_lines]]\nreset = \"btn0\"\n", 1, "gpio_lines is a table, [gpio_lines]");
}

TEST_F(ConfigFile, AValueThatNoSettingTakesIsNamed)
{
    expect_error("replies = [\"all\"]\n", 1,
                 "replies takes a string, a whole number or a boolean, "
                 "not an array");
    expect_error("emulated_threads = 1.5\n", 1, "not a number with a fraction");
    expect_error("emulated_threads = inf\n", 1, "emulated_threads takes");
    expect_error("state = 2026-01-02\n", 1, "not a date or a time");
    expect_error("state = 07:32:00\n", 1, "not a date or a time");
    expect_error("colour = [1]\n", 1, "there is no setting 'colour'");
    expect_error("colour = 1.5\n", 1, "there is no setting 'colour'");
    expect_error("basis_chek = \"off\"\n", 1,
                 "there is no setting 'basis_chek'; did you mean 'basis_check'?");
    expect_error("contrl = [1]\n", 1, "there is no setting 'contrl'; did you mean 'control'?");
    expect_error("[[colour]]\nx = 1\n", 1, "there is no setting 'colour'");
    expect_error("[gpio_lines]\nreset = 1.5\n", 2, "gpio_lines.reset takes a string");
    expect_error("[gpio_lines]\nbuzzer = [1]\n", 2, "unknown action 'buzzer'");
}

TEST_F(ConfigFile, AMissingFileIsNamed)
{
    const auto result = read_config_file(config, folder / "none.toml");
    ASSERT_FALSE(result);
    EXPECT_EQ(result.error().kind, ErrorKind::Config);
    EXPECT_NE(result.error().message.find("none.toml"), std::string::npos);
}

std::variant<Options, int> parse(std::vector<const char*> arguments)
{
    arguments.insert(arguments.begin(), "raymarchd");
    testing::internal::CaptureStdout();
    testing::internal::CaptureStderr();
    auto result = parse_command_line(static_cast<int>(arguments.size()), arguments.data());
    static_cast<void>(testing::internal::GetCapturedStdout());
    static_cast<void>(testing::internal::GetCapturedStderr());
    return result;
}

TEST(Options, EverySettingIsAnOption)
{
    for (const Setting& setting : settings()) {
        std::string option = "--" + std::string(setting.name);
        std::ranges::replace(option, '_', '-');
        const std::string value(setting.initial);
        const auto result = parse({option.c_str(), value.c_str()});
        ASSERT_TRUE(std::holds_alternative<Options>(result)) << option;
        const auto& given = std::get<Options>(result).settings;
        ASSERT_EQ(given.size(), 1U) << option;
        EXPECT_EQ(given[0].first, setting.name);
        EXPECT_EQ(given[0].second, value);
    }
}

TEST(Options, HelpAndVersionEndWell)
{
    EXPECT_EQ(std::get<int>(parse({"--help"})), 0);
    EXPECT_EQ(std::get<int>(parse({"--version"})), 0);
}

TEST(Options, AWrongCommandLineIsAUsageError)
{
    EXPECT_EQ(std::get<int>(parse({"--nosuch"})), 64);
    EXPECT_EQ(std::get<int>(parse({"stray"})), 64);
    EXPECT_EQ(std::get<int>(parse({"--serial"})), 64);
}

TEST(Options, TheCommandLineWinsOverTheFile)
{
    const test::TemporaryFolder folder;
    test::write_text(folder / "c.toml", "replies = \"errors\"\nbasis_check = \"off\"\n");
    Options options{.config_path = folder / "c.toml"};
    options.settings = {{"replies", "none"}};
    const auto config = load_config(options);
    ASSERT_TRUE(config) << config.error().message;
    EXPECT_EQ(config->replies, Replies::None);
    EXPECT_EQ(config->basis_check, BasisCheck::Off);
}

TEST(Options, ErrorsOfTheCommandLineNameTheOption)
{
    const test::TemporaryFolder folder;
    test::write_text(folder / "c.toml", "");
    Options options{.config_path = folder / "c.toml"};
    options.settings = {{"replies", "some"}};
    const auto config = load_config(options);
    ASSERT_FALSE(config);
    EXPECT_EQ(config.error().kind, ErrorKind::Usage);
    EXPECT_TRUE(config.error().message.starts_with("--replies: ")) << config.error().message;
}

TEST(Options, ANamedFileThatIsNotThereIsAnError)
{
    const test::TemporaryFolder folder;
    const auto config = load_config({.config_path = folder / "none.toml"});
    ASSERT_FALSE(config);
    EXPECT_EQ(config.error().kind, ErrorKind::Config);
}

} // namespace
} // namespace raymarch::daemon
