// SPDX-License-Identifier: MIT
/// @file
/// What a host leaves behind in the pseudo-terminal, however it ended: the next one starts afresh.
#include "fakes/waiting.hpp"
#include "service/support.hpp"

#include <gtest/gtest.h>

#include <fcntl.h>
#include <signal.h>
#include <sys/ioctl.h>
#include <termios.h>
#include <unistd.h>

#include <array>
#include <string>
#include <utility>
#include <vector>

namespace raymarch::tests
{
namespace
{

/// Whether the terminal keeps everybody but root out.
bool is_exclusive(const Host& host)
{
    int exclusive = -1;
    return ::ioctl(host.fd(), TIOCGEXCL, &exclusive) != 0 || exclusive != 0;
}

TEST(LeftBehind, TheToolLeavesTheTerminalOpenHoweverItEnds)
{
    const TemporaryFolder folder;
    const Service service(folder);
    ASSERT_TRUE(service.ready());
    for (const int how : {SIGINT, SIGTERM, SIGHUP, SIGKILL}) {
        SCOPED_TRACE(how);
        Process tool({RAYMARCHCTL, "watch", "--port", service.terminal()}, folder / "tool");
        ASSERT_TRUE(eventually([&] { return !tool.output().empty(); })) << tool.errors();
        {
            const Host beside = Host::on_terminal(service.terminal());
            EXPECT_FALSE(is_exclusive(beside)) << "nor while it runs";
        }
        tool.signal(how);
        ASSERT_NE(tool.wait(), -1);
        Host next = Host::on_terminal(service.terminal());
        EXPECT_FALSE(is_exclusive(next));
        EXPECT_EQ(run_tool(folder, {"status", "--socket", service.control()}).status, 0);
    }
    // Whose reply the next one hears is the tool's affair; the terminal itself is free.
    ASSERT_TRUE(
        eventually([&] { return Host::on_terminal(service.terminal()).ask("PING") == "OK"; }));
}

struct Leaving
{
    const char* name;
    void (*leave)(int fd);
};

void cook(int fd)
{
    termios settings = {};
    ::tcgetattr(fd, &settings);
    settings.c_lflag |= ICANON | ECHO | ISIG;
    settings.c_iflag |= ICRNL | IXON | IXOFF;
    settings.c_oflag |= OPOST | ONLCR;
    ::tcsetattr(fd, TCSANOW, &settings);
}

const std::vector<Leaving> leavings = {
    {"exclusive", [](int fd) { ::ioctl(fd, TIOCEXCL); }},
    {"stopped", [](int fd) { ::tcflow(fd, TCOOFF); }},
    {"cooked", cook},
    {"all of them",
     [](int fd) {
         cook(fd);
         ::tcflow(fd, TCOOFF);
         ::ioctl(fd, TIOCEXCL);
     }},
};

/// Other programs than ours do these things, too. As another user than root the service cannot take
/// the first one back, and makes a new terminal.
TEST(LeftBehind, BytesOfOtherProgramsDoNotReachTheNextHost)
{
    const TemporaryFolder folder;
    const Service service(folder);
    ASSERT_TRUE(service.ready());
    for (const bool speaks : {true, false})
        for (const Leaving& leaving : leavings) {
            SCOPED_TRACE(std::string(leaving.name) + (speaks ? ", spoke" : ", silent"));
            {
                Host host = Host::on_terminal(service.terminal());
                if (speaks) {
                    EXPECT_EQ(host.ask("PING"), "OK");
                }
                leaving.leave(host.fd());
            }
            const auto afresh = [&] {
                const Host next = Host::on_terminal(service.terminal());
                termios now = {};
                return !is_exclusive(next) && ::tcgetattr(next.fd(), &now) == 0 &&
                       now.c_lflag == 0 && now.c_iflag == 0 && now.c_oflag == 0;
            };
            ASSERT_TRUE(eventually(afresh));
            Host next = Host::on_terminal(service.terminal());
            EXPECT_EQ(next.ask("PING"), "OK");
            EXPECT_EQ(next.ask("GET ZM"), "OK ZM=3");
        }
}

/// The next host comes at once after the first, also while the service is not looking.
TEST(LeftBehind, HalfALineDoesNotReachTheNextHost)
{
    const TemporaryFolder folder;
    const Service service(folder);
    ASSERT_TRUE(service.ready());
    for (int i = 0; i < 20; ++i) {
        const bool asleep = i % 2 == 1;
        const std::string half = "SET ZM=9,LX=";
        {
            Host first = Host::on_terminal(service.terminal());
            EXPECT_EQ(first.ask("ECHO on"), "OK");
            first.send(half); // the service has read it when it comes back
            std::string echo;
            std::array<char, 64> bytes{};
            while (echo != half && test::readable(first.fd()))
                if (const ssize_t size = ::read(first.fd(), bytes.data(), bytes.size()); size > 0)
                    echo.append(bytes.data(), static_cast<std::size_t>(size));
            ASSERT_EQ(echo, half);
            if (asleep)
                service.process.signal(SIGSTOP);
        }
        Host next = Host::on_terminal(service.terminal());
        next.send("PING\n");
        if (asleep)
            service.process.signal(SIGCONT);
        ASSERT_EQ(next.reply(), "OK") << i;
        ASSERT_EQ(next.ask("GET ZM"), "OK ZM=3");
    }
}

TEST(LeftBehind, HangUpsAreCountedAlsoOverANewTerminal)
{
    const TemporaryFolder folder;
    const Service service(folder);
    ASSERT_TRUE(service.ready());
    for (int hosts = 1; hosts <= 3; ++hosts) {
        {
            Host host = Host::on_terminal(service.terminal());
            EXPECT_EQ(host.ask("PING"), "OK");
        }
        ASSERT_TRUE(
            eventually([&] { return service.status("hang_ups") == std::to_string(hosts); }));
    }
}

} // namespace
} // namespace raymarch::tests
