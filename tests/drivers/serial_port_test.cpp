// SPDX-License-Identifier: MIT
/// @file
/// A pseudo-terminal takes the place of the serial device.
#include "drivers/serial_port.hpp"

#include "tests/fakes/other_process.hpp"
#include "tests/fakes/temporary_folder.hpp"
#include "tests/fakes/waiting.hpp"

#include <gtest/gtest.h>

#include <fcntl.h>
#include <stdlib.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <array>
#include <cstring>
#include <string>

namespace raymarch::drivers
{
namespace
{

class Serial : public testing::Test
{
  protected:
    void SetUp() override
    {
        ASSERT_TRUE(line);
        ASSERT_EQ(::grantpt(line.get()), 0);
        ASSERT_EQ(::unlockpt(line.get()), 0);
        std::array<char, 64> name{};
        ASSERT_EQ(::ptsname_r(line.get(), name.data(), name.size()), 0);
        device = name.data();
    }
    /// Returns the settings of the device.
    [[nodiscard]] termios settings() const
    {
        termios now = {};
        EXPECT_EQ(::tcgetattr(line.get(), &now), 0);
        return now;
    }

    UniqueFd line{::posix_openpt(O_RDWR | O_NOCTTY | O_CLOEXEC)};
    std::string device;
};

TEST_F(Serial, IsRawWithEightBitsNoParityAndOneStopBit)
{
    const auto port = SerialPort::open(device, 115'200);
    ASSERT_TRUE(port) << port.error().message;
    const termios now = settings();
    EXPECT_EQ(now.c_lflag & static_cast<tcflag_t>(ICANON | ECHO | ECHONL | ISIG | IEXTEN), 0U);
    EXPECT_EQ(now.c_iflag & static_cast<tcflag_t>(ICRNL | INLCR | IGNCR | IXON | ISTRIP | PARMRK),
              0U);
    EXPECT_EQ(now.c_oflag & static_cast<tcflag_t>(OPOST), 0U);
    EXPECT_EQ(now.c_cflag & static_cast<tcflag_t>(CSIZE), static_cast<tcflag_t>(CS8));
    EXPECT_EQ(now.c_cflag & static_cast<tcflag_t>(PARENB | CSTOPB | CRTSCTS), 0U);
    EXPECT_NE(now.c_cflag & static_cast<tcflag_t>(CLOCAL), 0U);
    EXPECT_NE(now.c_cflag & static_cast<tcflag_t>(CREAD), 0U);
    EXPECT_EQ(::cfgetospeed(&now), static_cast<speed_t>(B115200));
    EXPECT_EQ(::cfgetispeed(&now), static_cast<speed_t>(B115200));
}

TEST_F(Serial, EveryListedSpeedIsTaken)
{
    for (const unsigned baud : {1200U, 9600U, 57'600U, 230'400U, 921'600U, 4'000'000U}) {
        const auto port = SerialPort::open(device, baud);
        EXPECT_TRUE(port) << baud;
    }
}

TEST_F(Serial, BytesGoThroughUnchanged)
{
    const auto port = SerialPort::open(device, 9600);
    ASSERT_TRUE(port);
    std::array<char, 64> bytes{};
    EXPECT_EQ((*port)->read(bytes).status, ReadStatus::Empty);
    ASSERT_EQ(::write(line.get(), "a\r\n\x03\x11\xFF", 6), 6);
    ASSERT_TRUE(test::readable((*port)->fd()));
    const ReadOutcome outcome = (*port)->read(bytes);
    EXPECT_EQ(outcome.status, ReadStatus::Data);
    EXPECT_EQ(std::string(bytes.data(), outcome.size), "a\r\n\x03\x11\xFF");
    EXPECT_EQ((*port)->write("OK\r\n"), 4U);
    ASSERT_TRUE(test::readable(line.get()));
    EXPECT_EQ(::read(line.get(), bytes.data(), bytes.size()), 4);
    EXPECT_EQ(std::memcmp(bytes.data(), "OK\r\n", 4), 0);
}

TEST_F(Serial, ASecondOpenerIsRefused)
{
    const auto first = SerialPort::open(device, 9600);
    ASSERT_TRUE(first);
    const auto second = SerialPort::open(device, 115'200);
    ASSERT_FALSE(second);
    EXPECT_EQ(second.error().kind, ErrorKind::Unavailable);
    EXPECT_NE(second.error().message.find(device), std::string::npos);
    const termios now = settings();
    EXPECT_EQ(::cfgetospeed(&now), static_cast<speed_t>(B9600)); // the first port's speed stays
}

TEST_F(Serial, ASecondOpenerHearsWhoHasIt)
{
    const test::OtherProcess other([&] { return SerialPort::open(device, 9600); });
    ASSERT_TRUE(other.has_it());
    const auto second = SerialPort::open(device, 9600);
    ASSERT_FALSE(second);
    EXPECT_NE(second.error().message.find("process " + std::to_string(other.pid())),
              std::string::npos)
        << second.error().message;
}

/// TIOCEXCL would stay after the program is killed, and keep out everybody except root.
TEST_F(Serial, AProgramThatIsKilledLeavesAPseudoTerminalOpenToOthers)
{
    test::OtherProcess other([&] { return SerialPort::open(device, 9600); });
    ASSERT_TRUE(other.has_it());
    const UniqueFd beside(::open(device.c_str(), O_RDWR | O_NOCTTY | O_NONBLOCK | O_CLOEXEC));
    ASSERT_TRUE(beside);
    int exclusive = -1;
    ASSERT_EQ(::ioctl(beside.get(), TIOCGEXCL, &exclusive), 0);
    EXPECT_EQ(exclusive, 0);
    other.kill();
    EXPECT_TRUE(SerialPort::open(device, 9600));
}

TEST_F(Serial, NothingOfAnEarlierUsersFlowControlStays)
{
    termios left = settings();
    left.c_iflag |= IXON | IXOFF | IXANY | INPCK;
    left.c_lflag |= TOSTOP;
    ASSERT_EQ(::tcsetattr(line.get(), TCSANOW, &left), 0);
    const auto port = SerialPort::open(device, 9600);
    ASSERT_TRUE(port) << port.error().message;
    EXPECT_EQ(settings().c_iflag, 0U);
    EXPECT_EQ(settings().c_lflag, 0U);
}

TEST_F(Serial, TheOldSettingsComeBack)
{
    const termios before = settings();
    {
        const auto port = SerialPort::open(device, 9600);
        ASSERT_TRUE(port);
        EXPECT_NE(settings().c_lflag, before.c_lflag);
    }
    EXPECT_EQ(settings().c_lflag, before.c_lflag);
    EXPECT_EQ(settings().c_iflag, before.c_iflag);
    EXPECT_EQ(settings().c_oflag, before.c_oflag);
    EXPECT_EQ(settings().c_cflag, before.c_cflag);
    EXPECT_TRUE(SerialPort::open(device, 9600)); // it can be opened again
}

TEST_F(Serial, ALineThatHangsUpIsGone)
{
    const auto port = SerialPort::open(device, 9600);
    ASSERT_TRUE(port);
    line.reset();
    std::array<char, 8> bytes{};
    EXPECT_EQ((*port)->read(bytes).status, ReadStatus::Gone);
    EXPECT_EQ((*port)->write("x"), 0U);
}

TEST_F(Serial, AFullLineTakesNothingAndDoesNotWait)
{
    const auto port = SerialPort::open(device, 9600);
    ASSERT_TRUE(port);
    const std::string much(1 << 20, 'x');
    std::size_t taken = 0;
    while (const std::size_t now = (*port)->write(much))
        taken += now;
    EXPECT_GT(taken, 0U);
    EXPECT_LT(taken, much.size());
}

TEST(SerialPort, AnUnknownSpeedListsThoseThatThereAre)
{
    for (const unsigned baud : {0U, 1U, 115'201U}) {
        const auto port = SerialPort::open("/dev/null", baud);
        ASSERT_FALSE(port);
        EXPECT_EQ(port.error().kind, ErrorKind::Usage);
        for (const char* part : {"1200 ", " 9600 ", " 115200 ", " 4000000"})
            EXPECT_NE(port.error().message.find(part), std::string::npos) << port.error().message;
    }
}

TEST(SerialPort, WhatIsNoTerminalIsRefused)
{
    const test::TemporaryFolder folder;
    test::write_text(folder / "file", "");
    for (const std::string& path : {folder / "file", folder / "none"}) {
        const auto port = SerialPort::open(path, 9600);
        ASSERT_FALSE(port) << path;
        EXPECT_EQ(port.error().kind, ErrorKind::Unavailable);
        EXPECT_NE(port.error().message.find(path), std::string::npos) << port.error().message;
    }
}

} // namespace
} // namespace raymarch::drivers
