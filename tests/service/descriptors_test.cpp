// SPDX-License-Identifier: MIT
/// @file
/// The programs without their standard descriptors, with few descriptors of their own, or with a
/// log that nobody reads.
#include "service/support.hpp"

#include <gtest/gtest.h>

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <sys/stat.h>
#include <sysexits.h>
#include <unistd.h>

#include <array>
#include <filesystem>
#include <fstream>

namespace raymarch::tests
{
namespace
{

namespace fs = std::filesystem;

struct Closed
{
    std::string redirections;
    std::vector<int> numbers;
};
const std::vector<Closed> closings = {
    {"2>&-", {2}},
    {"0<&-", {0}},
    {"1>&-", {1}},
    {"0<&- 2>&-", {0, 2}},
    {"0<&- 1>&- 2>&-", {0, 1, 2}},
};

/// Else the log would be written into the registers, or sent to the host.
TEST(Descriptors, TheServiceFillsThoseThatAreClosed)
{
    for (const Closed& closed : closings) {
        SCOPED_TRACE(closed.redirections);
        const TemporaryFolder folder;
        const Service service(folder, {"--log-level", "debug"}, {},
                              "exec \"$@\" " + closed.redirections);
        ASSERT_TRUE(service.ready());
        service.process.signal(SIGHUP); // something to log
        Host host = Host::on_terminal(service.terminal());
        EXPECT_EQ(host.ask("SET ZM=2"), "OK seq=1 changed=1");
        EXPECT_EQ(host.ask("SET ZM=3"), "OK seq=2 changed=1");
        EXPECT_EQ(service.words(), original_words);
        for (const int number : closed.numbers)
            EXPECT_EQ(fs::read_symlink("/proc/" + std::to_string(service.process.pid()) + "/fd/" +
                                       std::to_string(number)),
                      "/dev/null");
    }
}

TEST(Descriptors, TheToolFillsThoseThatAreClosed)
{
    const TemporaryFolder folder;
    const auto render = [&](const std::string& redirections, const std::string& name) {
        // Its own words go to standard output, or error: they must not end up in the picture.
        Process tool({"/bin/sh", "-c", "exec \"$@\" " + redirections, "sh", RAYMARCHCTL, "render",
                      "--size", "16x12", "-o", folder / name},
                     folder / "tool");
        EXPECT_EQ(tool.wait(), 0) << tool.errors();
        std::ifstream file(folder / name, std::ios::binary);
        return std::string(std::istreambuf_iterator<char>(file), {});
    };
    const std::string whole = render("", "whole.ppm");
    ASSERT_GT(whole.size(), 16U * 12 * 3);
    for (const Closed& closed : closings)
        EXPECT_EQ(render(closed.redirections, "closed.ppm"), whole) << closed.redirections;
}

/// A FIFO that is full before the service starts, and that nobody reads.
TEST(Descriptors, ALogThatNobodyReadsHoldsNothingUp)
{
    const TemporaryFolder folder;
    const std::string path = folder / "fifo";
    ASSERT_EQ(::mkfifo(path.c_str(), 0600), 0);
    const UniqueFd fifo(::open(path.c_str(), O_RDWR | O_NONBLOCK | O_CLOEXEC));
    ASSERT_TRUE(fifo);
    std::array<char, 4096> block{};
    block.fill('x');
    while (::write(fifo.get(), block.data(), block.size()) > 0) {
    }
    Service service(folder, {}, {}, "exec \"$@\" 2>'" + path + "'");
    ASSERT_TRUE(service.ready());
    for (int i = 0; i < 10; ++i) {
        service.process.signal(SIGHUP);
        EXPECT_EQ(Host::on_socket(service.control()).ask("PING"), "OK");
    }
    // It is read again: the next line that fits says how many are missing.
    std::string text;
    const auto read_all = [&] {
        for (ssize_t size = 0; (size = ::read(fifo.get(), block.data(), block.size())) > 0;)
            text.append(block.data(), static_cast<std::size_t>(size));
    };
    EXPECT_TRUE(eventually([&] {
        read_all();
        service.process.signal(SIGHUP);
        return text.find("of the log w") != std::string::npos &&
               text.find("configuration read again") != std::string::npos;
    })) << text;
    // And full once more, it ends when it is told to.
    block.fill('x');
    while (::write(fifo.get(), block.data(), block.size()) > 0) {
    }
    service.process.signal(SIGTERM);
    EXPECT_EQ(service.process.wait(), 0);
}

/// As few as one likes: the service says what is missing, or goes on without it; it does not crash.
TEST(Descriptors, TooFewAreToldOrDoneWithout)
{
#if defined(__SANITIZE_ADDRESS__)
    GTEST_SKIP() << "the sanitizer of undefined behaviour needs descriptors of its own";
#endif
    for (int limit = 1; limit <= 20; ++limit) {
        SCOPED_TRACE(limit);
        const TemporaryFolder folder;
        Service service(folder, {}, {}, "ulimit -n " + std::to_string(limit) + " && exec \"$@\"");
        ASSERT_TRUE(eventually(
            [&] { return !service.process.running() || service.count("ready: marcher") > 0; }));
        if (service.process.running())
            service.process.signal(SIGTERM);
        const int status = service.process.wait();
        // 126 and 127 are the shell's and the loader's, which need some, too.
        EXPECT_TRUE(status == 0 || status == EX_UNAVAILABLE || status == EX_OSERR ||
                    status == EX_IOERR || status == 126 || status == 127)
            << status << ": " << service.process.errors();
        if (status == EX_UNAVAILABLE) {
            EXPECT_EQ(service.count("Too many open files"), 1U) << service.process.errors();
        }
    }
}

} // namespace
} // namespace raymarch::tests
