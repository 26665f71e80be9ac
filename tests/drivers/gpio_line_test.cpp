// SPDX-License-Identifier: MIT
/// @file
/// Tests the errors for lines that do not exist. No machine has these names and labels, so the
/// tests also work on a machine with GPIO chips.
#include "drivers/gpio_line.hpp"

#include <gtest/gtest.h>

#include <cerrno>
#include <string>

namespace raymarch::drivers
{
namespace
{

Error refusal(std::string_view text, LineUse use = LineUse::Input)
{
    const auto pin = open_gpio_line(*parse_line_spec(text), use);
    EXPECT_FALSE(pin) << text;
    return pin ? Error{} : pin.error();
}

/// Also accepts the error that there is no chip.
void expect_message(const Error& error, const std::string& message)
{
    EXPECT_EQ(error.kind, ErrorKind::Unavailable);
    if (error.number == ENODEV) {
        EXPECT_EQ(error.message, "there is no GPIO chip");
    } else {
        EXPECT_TRUE(error.message.starts_with(message)) << error.message;
    }
}

TEST(GpioLine, ANameThatNoLineHasIsAnError)
{
    expect_message(refusal("raymarch-no-such-line"), "no GPIO line is named raymarch-no-such-line");
}

TEST(GpioLine, ALabelThatNoChipHasIsAnError)
{
    expect_message(refusal("raymarch-no-such-chip:0"),
                   "no GPIO chip has the label raymarch-no-such-chip");
}

TEST(GpioLine, APathThatIsNotThereIsAnError)
{
    const Error error = refusal("/dev/raymarch-no-such-chip:3", LineUse::Output);
    EXPECT_EQ(error.kind, ErrorKind::Unavailable);
    EXPECT_EQ(error.number, ENOENT);
    EXPECT_EQ(error.message, "GPIO line /dev/raymarch-no-such-chip:3: No such file or directory");
}

TEST(GpioLine, AFileThatIsNoChipIsAnError)
{
    const Error error = refusal("/dev/null:0");
    EXPECT_EQ(error.kind, ErrorKind::Unavailable);
    EXPECT_TRUE(error.message.starts_with("GPIO line /dev/null:0: ")) << error.message;
}

TEST(GpioLine, EveryPlaceThatWasTriedIsNamed)
{
    const Error error = refusal("/dev/raymarch-a:0|/dev/raymarch-b:1");
    EXPECT_NE(error.message.find("/dev/raymarch-a:0"), std::string::npos) << error.message;
    EXPECT_NE(error.message.find("/dev/raymarch-b:1"), std::string::npos) << error.message;
}

} // namespace
} // namespace raymarch::drivers
