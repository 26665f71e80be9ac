// SPDX-License-Identifier: MIT
#include "drivers/pseudo_terminal.hpp"

#include "base/unique_fd.hpp"
#include "drivers/lock_file.hpp"
#include "tests/fakes/other_process.hpp"
#include "tests/fakes/temporary_folder.hpp"
#include "tests/fakes/waiting.hpp"

#include <gtest/gtest.h>

#include <fcntl.h>
#include <sys/epoll.h>
#include <sys/file.h>
#include <sys/ioctl.h>
#include <sys/stat.h>
#include <termios.h>
#include <unistd.h>

#include <array>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace raymarch::drivers
{
namespace
{

namespace fs = std::filesystem;

/// A host is a program that opens the link.
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
    /// Reads all bytes that have come.
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
    while (read_status() == ReadStatus::Data) { // drops the echo
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

TEST_F(Pty, ASecondServiceIsKeptOffAndHearsWhy)
{
    const auto second = PseudoTerminal::open(link);
    ASSERT_FALSE(second);
    EXPECT_TRUE(held_by_another(second.error()));
    EXPECT_NE(second.error().message.find(link), std::string::npos);
    EXPECT_EQ(fs::read_symlink(link), port->name());
}

TEST_F(Pty, TheLinkOfAKilledServiceIsReplaced)
{
    const std::string other_link = folder / "other";
    test::OtherProcess other([&] { return PseudoTerminal::open(other_link); });
    ASSERT_TRUE(other.has_it());
    const auto early = PseudoTerminal::open(other_link);
    ASSERT_FALSE(early);
    EXPECT_NE(early.error().message.find("process " + std::to_string(other.pid())),
              std::string::npos)
        << early.error().message;
    other.kill();
    const auto port_again = PseudoTerminal::open(other_link);
    ASSERT_TRUE(port_again) << port_again.error().message;
    EXPECT_EQ(fs::read_symlink(other_link), (*port_again)->name());
}

TEST_F(Pty, ALinkThatWasReplacedIsLeftAlone)
{
    fs::rename(link, folder / "away"); // the inode number of the old link stays in use
    EXPECT_FALSE(port->link_in_place());
    fs::create_symlink(port->name(), link); // it has the same target, but is another link
    EXPECT_FALSE(port->link_in_place());
    EXPECT_FALSE(port->restore_link());
    port.reset();
    EXPECT_TRUE(fs::is_symlink(fs::symlink_status(link)));
}

TEST_F(Pty, ALinkThatWasRemovedCanBeMadeAgain)
{
    EXPECT_TRUE(port->restore_link()); // there is nothing to do
    fs::remove(link);
    EXPECT_FALSE(port->link_in_place());
    const auto restored = port->restore_link();
    ASSERT_TRUE(restored) << restored.error().message;
    EXPECT_TRUE(port->link_in_place());
    EXPECT_EQ(fs::read_symlink(link), port->name());
    test::write_text(folder / "file", "precious");
    fs::rename(folder / "file", link);
    EXPECT_FALSE(port->restore_link());
    EXPECT_EQ(test::read_text(link), "precious");
}

TEST_F(Pty, IsForItsOwnerAndGroup)
{
    struct stat info = {};
    ASSERT_EQ(::stat(link.c_str(), &info), 0);
    EXPECT_EQ(info.st_mode & 07777U, 0660U);
    EXPECT_EQ(info.st_gid, ::getegid());
}

/// Whatever a host leaves in the terminal, the next host finds it as the first one did, even if the
/// first one sent nothing.
struct Leaving
{
    const char* name;
    void (*leave)(int fd);
};

void change(int fd, void (*how)(termios&))
{
    termios settings = {};
    EXPECT_EQ(::tcgetattr(fd, &settings), 0);
    how(settings);
    EXPECT_EQ(::tcsetattr(fd, TCSANOW, &settings), 0);
}

const std::vector<Leaving> leavings = {
    {"nothing", [](int) {}},
    {"exclusive", [](int fd) { EXPECT_EQ(::ioctl(fd, TIOCEXCL), 0); }},
    {"stopped", [](int fd) { EXPECT_EQ(::tcflow(fd, TCOOFF), 0); }},
    {"locked", [](int fd) { EXPECT_EQ(::flock(fd, LOCK_EX | LOCK_NB), 0); }},
    {"cooked", [](int fd) { change(fd, [](termios& t) { t.c_lflag |= ICANON | ECHO | ISIG; }); }},
    {"translated",
     [](int fd) {
         change(fd, [](termios& t) {
             t.c_iflag |= IXON | IXOFF | ICRNL | IUCLC;
             t.c_oflag |= OPOST | ONLCR | OLCUC;
         });
     }},
    {"seven bits, slow",
     [](int fd) {
         change(fd, [](termios& t) {
             t.c_cflag = (t.c_cflag & ~static_cast<tcflag_t>(CSIZE)) | CS7 | PARENB;
             t.c_cc[VMIN] = 9;
             ::cfsetspeed(&t, B300);
         });
     }},
    {"all at once",
     [](int fd) {
         change(fd, [](termios& t) { t.c_lflag |= ICANON | ECHO; });
         EXPECT_EQ(::tcflow(fd, TCOOFF), 0);
         EXPECT_EQ(::ioctl(fd, TIOCEXCL), 0);
     }},
};

class LeftBehind : public Pty, public testing::WithParamInterface<bool>
{};

TEST_P(LeftBehind, BytesDoNotReachTheNextHost)
{
    const bool speaks = GetParam();
    const termios first = Host(link).settings();
    for (const Leaving& leaving : leavings) {
        SCOPED_TRACE(leaving.name);
        {
            const Host host(link);
            if (speaks)
                host.say("PING\n");
            leaving.leave(host.fd());
        }
        ReadStatus status = read_status();
        while (status == ReadStatus::Data || status == ReadStatus::HungUp)
            status = read_status();
        if (status == ReadStatus::Gone) { // without root, a new terminal replaces it
            port.reset();
            SetUp();
        }
        const Host next(link);
        ASSERT_GE(next.fd(), 0);
        const termios now = next.settings();
        EXPECT_EQ(now.c_iflag, first.c_iflag);
        EXPECT_EQ(now.c_oflag, first.c_oflag);
        EXPECT_EQ(now.c_cflag, first.c_cflag);
        EXPECT_EQ(now.c_lflag, first.c_lflag);
        EXPECT_EQ(now.c_cc[VMIN], first.c_cc[VMIN]);
        EXPECT_EQ(::flock(next.fd(), LOCK_EX | LOCK_NB), 0);
        const Host beside(link); // the terminal is not exclusive, so a second host may open it
        next.say("x");
        EXPECT_EQ(read_text(), "x");
        EXPECT_EQ(port->write("OK\r\n"), 4U);
        EXPECT_TRUE(test::readable(next.fd()));
        EXPECT_EQ(next.hear(), "OK\r\n");
    }
}

INSTANTIATE_TEST_SUITE_P(Hosts, LeftBehind, testing::Values(true, false), [](const auto& row) {
    return row.param ? "AfterAHostThatSpoke" : "AfterASilentHost";
});

/// The service was busy while one host left and the next came, so it never saw the terminal closed.
/// The half line that it has read belongs to the first host.
TEST_F(Pty, AHostThatIsFollowedAtOnceIsSeenToLeave)
{
    for (const Leaving& leaving : leavings) {
        if (std::string_view(leaving.name).find("exclusive") != std::string_view::npos ||
            leaving.name == std::string_view("all at once"))
            continue; // exclusive mode keeps out the next host, unless it is root
        SCOPED_TRACE(leaving.name);
        while (read_status() !=
               ReadStatus::Empty) { // until the hang-up of the last host has been read
        }
        std::optional<Host> first(std::in_place, link);
        port->look();
        first->say("PIN");
        EXPECT_EQ(read_text(), "PIN");
        EXPECT_EQ(read_status(), ReadStatus::Empty);
        EXPECT_EQ(port->write("a reply\r\n"), 9U);
        EXPECT_TRUE(test::readable(first->fd())); // before its settings change
        leaving.leave(first->fd());
        first.reset();
        const Host next(link);
        EXPECT_TRUE(test::readable(port->visits_fd()));
        port->look();
        EXPECT_EQ(next.hear(), "") << "the first one's reply";
        expect_raw(next.settings());
        next.say("PING\n");
        EXPECT_EQ(read_status(), ReadStatus::HungUp);
        EXPECT_EQ(read_text(), "PING\n");
        EXPECT_EQ(port->write("OK\r\n"), 4U);
        EXPECT_TRUE(test::readable(next.fd()));
        EXPECT_EQ(next.hear(), "OK\r\n");
    }
}

/// One program reads while others write one after the other, so the terminal is always open.
TEST_F(Pty, WhoReadsBesideOthersThatComeAndGoLosesNothing)
{
    const Host reader(link);
    port->look();
    for (int i = 0; i < 3; ++i) {
        Host(link).say("PING\n");
        EXPECT_EQ(read_text(), "PING\n");
        EXPECT_EQ(read_status(), ReadStatus::Empty);
        EXPECT_EQ(port->write("OK\r\n"), 4U);
        port->look();
    }
    EXPECT_EQ(read_status(), ReadStatus::Empty);
    std::string heard;
    while (heard.size() < 12 && test::readable(reader.fd()))
        heard += reader.hear();
    EXPECT_EQ(heard, "OK\r\nOK\r\nOK\r\n");
}

/// Two hosts that come together are counted as one. The service's own open() must not count as a
/// new host then, because each reset would cause the next one.
TEST_F(Pty, ComesToRestAlsoWhenHostsWereMiscounted)
{
    std::optional<Host> first(std::in_place, link);
    const Host stays(link);
    for (int i = 0; i < 3; ++i) {
        port->look();
        first.reset();
        static_cast<void>(Host(link)); // comes and leaves
        for (int looks = 0; test::readable(port->visits_fd(), 0); ++looks) {
            ASSERT_LT(looks, 5);
            port->look();
        }
        while (read_status() != ReadStatus::Empty) { // taken for a hang-up
        }
        stays.say("PING\n");
        EXPECT_EQ(read_text(), "PING\n");
        EXPECT_EQ(port->write("OK\r\n"), 4U);
        port->look();
        EXPECT_EQ(read_status(), ReadStatus::Empty);
        EXPECT_TRUE(test::readable(stays.fd()));
        EXPECT_EQ(stays.hear(), "OK\r\n");
        first.emplace(link);
        static_cast<void>(Host(link));
    }
}

/// When the service opens the other end itself, its own events must not wake it again.
TEST_F(Pty, ComesToRestAfterAHostHasLeft)
{
    Host(link).say("PING\n");
    EXPECT_EQ(read_text(), "PING\n");
    const UniqueFd waiting(::epoll_create1(EPOLL_CLOEXEC));
    epoll_event event = {.events = EPOLLIN | EPOLLET, .data = {}};
    ASSERT_EQ(::epoll_ctl(waiting.get(), EPOLL_CTL_ADD, port->fd(), &event), 0);
    int hang_ups = 0;
    for (int wakes = 0; ::epoll_wait(waiting.get(), &event, 1, 100) > 0; ++wakes) {
        ASSERT_LT(wakes, 10);
        for (ReadStatus status = read_status(); status != ReadStatus::Empty; status = read_status())
            hang_ups += status == ReadStatus::HungUp ? 1 : 0;
    }
    EXPECT_EQ(hang_ups, 1);
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
