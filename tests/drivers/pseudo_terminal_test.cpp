// SPDX-License-Identifier: MIT
#include "drivers/pseudo_terminal.hpp"

#include "base/unique_fd.hpp"
#include "tests/fakes/temporary_folder.hpp"
#include "tests/fakes/waiting.hpp"

#include <gtest/gtest.h>

#include <fcntl.h>
#include <termios.h>
#include <unistd.h>

#include <array>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>

namespace raymarch::drivers
{
namespace
{

namespace fs = std::filesystem;

/// A host at the other end, as a program that opens the link.
class Host
{
  public:
    explicit Host(const std::string& link)
        : fd_(::open(link.c_str(), O_RDWR | O_NOCTTY | O_NONBLOCK | O_CLOEXEC))
    {
        EXPECT_TRUE(fd_) << link;
    }
    void say(std::string_view text) const
    {
        EXPECT_EQ(::write(fd_.get(), text.data(), text.size()), static_cast<ssize_t>(text.size()));
    }
    /// What is there to be read, which may be nothing.
    [[nodiscard]] std::string hear() const
    {
        std::array<char, 256> bytes{};
        const ssize_t size = ::read(fd_.get(), bytes.data(), bytes.size());
        return size > 0 ? std::string(bytes.data(), static_cast<std::size_t>(size)) : std::string();
    }
    [[nodiscard]] termios settings() const
    {
        termios now = {};
        EXPECT_EQ(::tcgetattr(fd_.get(), &now), 0);
        return now;
    }
    void set(const termios& settings) const
    {
        EXPECT_EQ(::tcsetattr(fd_.get(), TCSANOW, &settings), 0);
    }
    [[nodiscard]] int fd() const { return fd_.get(); }

  private:
    UniqueFd fd_;
};

void expect_raw(const termios& settings)
{
    EXPECT_EQ(settings.c_lflag & static_cast<tcflag_t>(ICANON | ECHO | ISIG | IEXTEN), 0U);
    EXPECT_EQ(settings.c_iflag & static_cast<tcflag_t>(ICRNL | IXON | INLCR | IGNCR), 0U);
    EXPECT_EQ(settings.c_oflag & static_cast<tcflag_t>(OPOST), 0U);
}

class Pty : public testing::Test
{
  protected:
    void SetUp() override
    {
        auto opened = PseudoTerminal::open(link);
        ASSERT_TRUE(opened) << opened.error().message;
        port = std::move(*opened);
    }
    ReadStatus read_status()
    {
        std::array<char, 256> bytes{};
        return port->read(bytes).status;
    }
    std::string read_text()
    {
        std::array<char, 256> bytes{};
        if (!test::readable(port->fd()))
            return "nothing came";
        const ReadOutcome outcome = port->read(bytes);
        return outcome.status == ReadStatus::Data ? std::string(bytes.data(), outcome.size)
                                                  : "no data";
    }

    test::TemporaryFolder folder;
    std::string link = folder / "tty";
    std::unique_ptr<PseudoTerminal> port;
};

TEST_F(Pty, TheLinkLeadsToIt)
{
    EXPECT_EQ(fs::read_symlink(link), port->name());
    EXPECT_TRUE(port->name().starts_with("/dev/pts/"));
}

TEST_F(Pty, IsRawWithoutAHostDoingAnything)
{
    expect_raw(Host(link).settings());
}

TEST_F(Pty, BytesGoThroughUnchanged)
{
    const Host host(link);
    host.say("a\rb\nc\x03\x04\x11\xFF");
    EXPECT_EQ(read_text(), "a\rb\nc\x03\x04\x11\xFF");
    EXPECT_EQ(read_status(), ReadStatus::Empty); // nothing is echoed
    EXPECT_EQ(port->write("OK\r\n"), 4U);
    EXPECT_TRUE(test::readable(host.fd()));
    EXPECT_EQ(host.hear(), "OK\r\n");
}

TEST_F(Pty, WithoutAHostThereIsNothingToRead)
{
    EXPECT_NE(read_status(), ReadStatus::Gone);
    EXPECT_EQ(read_status(), ReadStatus::Empty);
}

TEST_F(Pty, AHangUpIsReportedOnce)
{
    {
        const Host host(link);
        host.say("PING\n");
        EXPECT_EQ(read_text(), "PING\n");
    }
    EXPECT_EQ(read_status(), ReadStatus::HungUp);
    for (int i = 0; i < 3; ++i)
        EXPECT_EQ(read_status(), ReadStatus::Empty);
    const Host next(link);
    next.say("x");
    EXPECT_EQ(read_text(), "x");
}

TEST_F(Pty, WhatAHostSaidBeforeItLeftIsStillRead)
{
    Host(link).say("PING\n");
    EXPECT_EQ(read_text(), "PING\n");
    EXPECT_EQ(read_status(), ReadStatus::HungUp);
}

TEST_F(Pty, RepliesThatWereNotReadDoNotGreetTheNextHost)
{
    {
        const Host host(link);
        host.say("PING\n");
        EXPECT_EQ(read_text(), "PING\n");
    }
    EXPECT_EQ(port->write("OK\r\n"), 4U); // too late
    EXPECT_EQ(read_status(), ReadStatus::HungUp);
    EXPECT_EQ(Host(link).hear(), "");
}

TEST_F(Pty, TheSettingsOfAHostThatSpokeDoNotStay)
{
    {
        const Host host(link);
        termios cooked = host.settings();
        cooked.c_lflag |= static_cast<tcflag_t>(ICANON | ECHO);
        host.set(cooked);
        host.say("PING\n");
        EXPECT_EQ(read_text().substr(0, 5), "PING\n");
    }
    while (read_status() == ReadStatus::Data) { // what was echoed
    }
    expect_raw(Host(link).settings());
}

TEST_F(Pty, TheSettingsOfASilentHostDoNotStay)
{
    Host(link).say("PING\n");
    EXPECT_EQ(read_text(), "PING\n");
    EXPECT_EQ(read_status(), ReadStatus::HungUp);
    {
        const Host silent(link);
        termios cooked = silent.settings();
        cooked.c_lflag |= static_cast<tcflag_t>(ICANON | ECHO);
        silent.set(cooked);
    }
    static_cast<void>(read_status());
    expect_raw(Host(link).settings());
}

TEST_F(Pty, TheLinkGoesWithIt)
{
    port.reset();
    EXPECT_FALSE(fs::exists(fs::symlink_status(link)));
}

TEST_F(Pty, ALinkThatIsThereIsReplacedAndThenNotRemovedByTheOldOne)
{
    auto second = PseudoTerminal::open(link);
    ASSERT_TRUE(second);
    EXPECT_EQ(fs::read_symlink(link), (*second)->name());
    port.reset(); // the link is no longer its own
    EXPECT_EQ(fs::read_symlink(link), (*second)->name());
}

TEST(PseudoTerminal, ADanglingLinkIsReplaced)
{
    const test::TemporaryFolder folder;
    fs::create_symlink("/nowhere/at/all", folder / "tty");
    const auto port = PseudoTerminal::open(folder / "tty");
    ASSERT_TRUE(port) << port.error().message;
    EXPECT_EQ(fs::read_symlink(folder / "tty"), (*port)->name());
}

TEST(PseudoTerminal, AnythingElseThanALinkStays)
{
    const test::TemporaryFolder folder;
    test::write_text(folder / "file", "precious");
    const auto port = PseudoTerminal::open(folder / "file");
    ASSERT_FALSE(port);
    EXPECT_EQ(port.error().kind, ErrorKind::Unavailable);
    EXPECT_NE(port.error().message.find(folder / "file"), std::string::npos);
    EXPECT_EQ(test::read_text(folder / "file"), "precious");
}

TEST(PseudoTerminal, AFolderThatIsNotThereIsNamed)
{
    const test::TemporaryFolder folder;
    const auto port = PseudoTerminal::open(folder / "missing/tty");
    ASSERT_FALSE(port);
    EXPECT_NE(port.error().message.find(folder / "missing/tty"), std::string::npos);
}

} // namespace
} // namespace raymarch::drivers
