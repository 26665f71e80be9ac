// SPDX-License-Identifier: MIT
#include "drivers/tty_name.hpp"

#include <gtest/gtest.h>

#include <array>

namespace raymarch::drivers
{
namespace
{

struct Row
{
    std::string_view text;
    std::string_view path;
    unsigned baud;
};
constexpr std::array rows = {
    Row{"/dev/ttyPS0", "/dev/ttyPS0", 115'200},
    Row{"/dev/ttyPS0@9600", "/dev/ttyPS0", 9600},
    Row{"tty@1200", "tty", 1200},
    Row{"/home/jane@corp.example/tty", "/home/jane@corp.example/tty", 115'200},
    Row{"/home/jane@corp.example/tty@9600", "/home/jane@corp.example/tty", 9600},
    Row{"/home/jane@9600/tty", "/home/jane@9600/tty", 115'200},
    Row{"/dev/tty@x@1200", "/dev/tty@x", 1200},
    Row{"/dev/tty@@1200", "/dev/tty@", 1200},
    Row{"/my folder/tty@1200", "/my folder/tty", 1200},
};

TEST(TtyName, IsAPathAndABaudRate)
{
    for (const Row& row : rows) {
        const auto name = parse_tty_name(row.text);
        ASSERT_TRUE(name) << row.text << ": " << name.error().message;
        EXPECT_EQ(name->path, row.path) << row.text;
        EXPECT_EQ(name->baud, row.baud) << row.text;
    }
}

struct Refusal
{
    std::string_view text;
    std::string_view message; ///< a part of it
};
constexpr std::array refusals = {
    Refusal{"", "there is no path"},
    Refusal{"@9600", "there is no path"},
    Refusal{"/dev/ttyS0@", "no baud rate follows the @"},
    Refusal{"/dev/ttyS0@fast", "'fast' is not a baud rate"},
    Refusal{"/dev/ttyS0@-9600", "'-9600' is not a baud rate"},
    Refusal{"/dev/ttyS0@+9600", "'+9600' is not a baud rate"},
    Refusal{"/dev/ttyS0@0x2580", "'0x2580' is not a baud rate"},
    Refusal{"/dev/ttyS0@9600 ", "'9600 ' is not a baud rate"},
    Refusal{"/dev/ttyS0@ 9600", "' 9600' is not a baud rate"},
    Refusal{"/dev/ttyS0@0", "'0' is not a baud rate; the rates are 1200 "},
    Refusal{"/dev/ttyS0@115201", "'115201' is not a baud rate; the rates are 1200 "},
    Refusal{"/dev/ttyS0@99999999999", "'99999999999' is not a baud rate; the rates are 1200 "},
    Refusal{"/dev/ttyS0@4294976896", "'4294976896' is not a baud rate"}, // 9600 in 32 bits
    Refusal{"/dev/ttyUSB0 @115200", "the path begins or ends with a blank"},
    Refusal{" /dev/ttyUSB0", "the path begins or ends with a blank"},
    Refusal{"/dev/ttyUSB0\n", "the path begins or ends with a blank"},
};

TEST(TtyName, ARefusalSaysWhatIsWrong)
{
    for (const Refusal& row : refusals) {
        const auto name = parse_tty_name(row.text);
        ASSERT_FALSE(name) << row.text;
        EXPECT_EQ(name.error().kind, ErrorKind::Usage);
        EXPECT_NE(name.error().message.find(row.message), std::string::npos)
            << name.error().message;
    }
}

} // namespace
} // namespace raymarch::drivers
