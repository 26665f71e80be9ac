// SPDX-License-Identifier: MIT
/// @file
/// The log at its output: it never waits for whoever reads, says what was lost, and no text makes a
/// line of its own. Each test has standard error to itself: in a child process.
#include "base/log.hpp"

#include "base/unique_fd.hpp"
#include "tests/fakes/temporary_folder.hpp"

#include <gtest/gtest.h>

#include <fcntl.h>
#include <poll.h>
#include <stdlib.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <termios.h>
#include <unistd.h>

#include <array>
#include <functional>
#include <string>
#include <thread>
#include <vector>

namespace raymarch::log
{
namespace
{

/// The two ends of something that can be standard error.
struct Channel
{
    UniqueFd ours;   ///< the reader's
    UniqueFd errors; ///< standard error
    UniqueFd keep;   ///< kept open besides
};

Channel make_pipe()
{
    std::array<int, 2> ends{-1, -1};
    EXPECT_EQ(::pipe2(ends.data(), O_CLOEXEC), 0);
    return {UniqueFd(ends[0]), UniqueFd(ends[1]), {}};
}

Channel make_sockets()
{
    std::array<int, 2> ends{-1, -1};
    EXPECT_EQ(::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends.data()), 0);
    return {UniqueFd(ends[0]), UniqueFd(ends[1]), {}};
}

Channel make_terminal()
{
    UniqueFd line(::posix_openpt(O_RDWR | O_NOCTTY | O_CLOEXEC));
    std::array<char, 64> name{};
    EXPECT_EQ(::grantpt(line.get()), 0);
    EXPECT_EQ(::unlockpt(line.get()), 0);
    EXPECT_EQ(::ptsname_r(line.get(), name.data(), name.size()), 0);
    UniqueFd terminal(::open(name.data(), O_RDWR | O_NOCTTY | O_CLOEXEC));
    termios raw = {};
    EXPECT_EQ(::tcgetattr(terminal.get(), &raw), 0);
    ::cfmakeraw(&raw);
    EXPECT_EQ(::tcsetattr(terminal.get(), TCSANOW, &raw), 0);
    return {std::move(line), std::move(terminal), {}};
}

/// Ctrl-S: the terminal takes nothing at all.
Channel make_stopped_terminal()
{
    Channel channel = make_terminal();
    EXPECT_EQ(::tcflow(channel.errors.get(), TCOOFF), 0);
    return channel;
}

struct Kind
{
    const char* name;
    Channel (*make)();
};
constexpr std::array kinds = {Kind{"pipe", make_pipe}, Kind{"socket", make_sockets},
                              Kind{"terminal", make_terminal},
                              Kind{"stopped terminal", make_stopped_terminal}};

/// A child whose standard error is `errors`; it reports over a pipe of its own when it has come to
/// the end of `act`, and then waits to be ended.
class Child
{
  public:
    Child(int errors, const std::function<void()>& act)
    {
        std::array<int, 2> ends{-1, -1};
        EXPECT_EQ(::pipe2(ends.data(), O_CLOEXEC), 0);
        done_ = UniqueFd(ends[0]);
        const UniqueFd tell(ends[1]);
        pid_ = ::fork();
        if (pid_ == 0) {
            ::unsetenv("JOURNAL_STREAM"); // NOLINT(concurrency-mt-unsafe): the child has one thread
            ::dup2(errors, STDERR_FILENO);
            act();
            static_cast<void>(::write(tell.get(), "d", 1));
            ::_exit(0);
        }
    }
    Child(const Child&) = delete;
    Child& operator=(const Child&) = delete;
    ~Child()
    {
        ::kill(pid_, SIGKILL);
        ::waitpid(pid_, nullptr, 0);
    }
    /// Whether it came to its end; only a defect lets this wait long.
    [[nodiscard]] bool done() const
    {
        pollfd end = {.fd = done_.get(), .events = POLLIN, .revents = 0};
        char word = 0;
        return ::poll(&end, 1, 20'000) > 0 && ::read(done_.get(), &word, 1) == 1;
    }

  private:
    UniqueFd done_;
    pid_t pid_ = -1;
};

/// All that is there to be read now.
std::string read_all(int fd)
{
    std::string text;
    std::array<char, 65'536> chunk{};
    pollfd end = {.fd = fd, .events = POLLIN, .revents = 0};
    while (::poll(&end, 1, 0) > 0 && (end.revents & POLLIN) != 0) {
        const ssize_t size = ::read(fd, chunk.data(), chunk.size());
        if (size <= 0)
            break;
        text.append(chunk.data(), static_cast<std::size_t>(size));
    }
    return text;
}

constexpr int flood = 20'000; // lines of a hundred bytes: more than any buffer here holds

void log_a_flood()
{
    for (int i = 0; i < flood; ++i)
        warning("line {:05} {}", i, std::string(80, 'x'));
}

TEST(LogOutput, NeverWaitsForAReader)
{
    for (const Kind& kind : kinds) {
        Channel channel = kind.make();
        const Child child(channel.errors.get(), log_a_flood);
        EXPECT_TRUE(child.done()) << kind.name;
    }
}

/// Standard error may be shared: what others see of it must stay as it was.
TEST(LogOutput, LeavesTheSharedDescriptorAsItIs)
{
    for (const Kind& kind : kinds) {
        Channel channel = kind.make();
        const int before = ::fcntl(channel.errors.get(), F_GETFL);
        const Child child(channel.errors.get(), [] { warning("a line"); });
        ASSERT_TRUE(child.done()) << kind.name;
        EXPECT_EQ(::fcntl(channel.errors.get(), F_GETFL), before) << kind.name;
    }
}

/// Every line is either there, whole, or in the count.
TEST(LogOutput, SaysHowManyLinesWereLost)
{
    for (const Kind& kind : {kinds[0], kinds[1], kinds[2]}) {
        SCOPED_TRACE(kind.name);
        Channel channel = kind.make();
        const Channel flooded = make_pipe();
        const Channel room = make_pipe();
        const Child child(channel.errors.get(), [&] {
            log_a_flood();
            static_cast<void>(::write(flooded.errors.get(), "f", 1));
            char word = 0;
            static_cast<void>(::read(room.ours.get(), &word, 1));
            warning("the last");
        });
        char word = 0;
        ASSERT_EQ(::read(flooded.ours.get(), &word, 1), 1);
        std::string text; // a terminal passes on what it holds as it is read
        pollfd more = {.fd = channel.ours.get(), .events = POLLIN, .revents = 0};
        while (::poll(&more, 1, 300) > 0)
            text += read_all(channel.ours.get());
        ASSERT_EQ(::write(room.errors.get(), "r", 1), 1);
        ASSERT_TRUE(child.done());
        while (::poll(&more, 1, 300) > 0)
            text += read_all(channel.ours.get());

        long long whole = 0;
        long long lost = 0;
        bool last = false;
        std::size_t begin = 0;
        for (std::size_t end = 0; (end = text.find('\n', begin)) != std::string::npos;
             begin = end + 1) {
            const std::string line = text.substr(begin, end - begin);
            if (line.find(" of the log w") != std::string::npos)
                lost += std::stoll(line.substr(std::string("raymarchd: ").size()));
            else if (line.starts_with("raymarchd: line ") && line.ends_with(std::string(80, 'x')))
                ++whole;
            else if (line == "raymarchd: the last")
                last = true;
        }
        EXPECT_TRUE(last) << text.substr(text.size() > 300 ? text.size() - 300 : 0);
        EXPECT_EQ(whole + lost, flood);
    }
}

/// What one message writes to a pipe.
std::string logged(const std::string& message)
{
    Channel channel = make_pipe();
    const Child child(channel.errors.get(), [&] { warning("{}", message); });
    EXPECT_TRUE(child.done());
    return read_all(channel.ours.get());
}

TEST(LogOutput, NoTextMakesALineOfItsOwn)
{
    struct Row
    {
        std::string text;
        std::string shown;
    };
    const std::vector<Row> rows = {
        {"open a\nraymarchd: all is well", "open a\\x0araymarchd: all is well"},
        {"a\r\nb\tc", "a\\x0d\\x0ab\\x09c"},
        {std::string("a\0b", 3), "a\\x00b"},
        {"\x1B[2J\x7F", "\\x1b[2J\\x7f"},
        {"\xC2\x9B"
         "2J",
         "\xC2\\x9b2J"},
        {"M\xC3\xBCller \xE2\x82\xAC \xC2\xA0.", "M\xC3\xBCller \xE2\x82\xAC \xC2\xA0."},
        {"", ""},
    };
    for (const Row& row : rows)
        EXPECT_EQ(logged(row.text), "raymarchd: " + row.shown + "\n");
}

TEST(LogOutput, AVeryLongLineIsCutAndSaysSo)
{
    const std::size_t room = longest_line - std::string("raymarchd: ").size() - 4;
    EXPECT_EQ(logged(std::string(room, 'x')), "raymarchd: " + std::string(room, 'x') + "\n");
    const std::string cut = logged(std::string(room + 1, 'x'));
    EXPECT_EQ(cut, "raymarchd: " + std::string(room, 'x') + "...\n");
    EXPECT_LE(logged(std::string(100'000, '\n')).size(), longest_line);
}

TEST(LogOutput, LinesOfManyThreadsStayWhole)
{
    const test::TemporaryFolder folder; // a file has room for all
    const UniqueFd file(::open((folder / "log").c_str(), O_WRONLY | O_CREAT | O_CLOEXEC, 0600));
    const Child child(file.get(), [] {
        std::vector<std::jthread> threads;
        for (int thread = 0; thread < 4; ++thread)
            threads.emplace_back([thread] {
                for (int i = 0; i < 100; ++i)
                    warning("{}{}", thread, std::string(200, static_cast<char>('a' + thread)));
            });
    });
    ASSERT_TRUE(child.done());
    const std::string text = test::read_text(folder / "log");
    std::size_t begin = 0;
    int lines = 0;
    for (std::size_t end = 0; (end = text.find('\n', begin)) != std::string::npos;
         begin = end + 1) {
        const std::string line = text.substr(begin, end - begin);
        ASSERT_EQ(line.size(), 11U + 1 + 200) << line;
        ASSERT_EQ(line.substr(12), std::string(200, static_cast<char>('a' + (line[11] - '0'))));
        ++lines;
    }
    EXPECT_EQ(lines, 400);
}

} // namespace
} // namespace raymarch::log
