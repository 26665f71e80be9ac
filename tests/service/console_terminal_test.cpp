// SPDX-License-Identifier: MIT
/// @file
/// Tests `raymarchctl console`: typed and piped lines are sent unchanged.
#include "service/far_end.hpp"

#include <gtest/gtest.h>

#include <fcntl.h>
#include <poll.h>
#include <stdlib.h>
#include <sys/ioctl.h>
#include <sys/wait.h>
#include <sysexits.h>
#include <termios.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <chrono>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <thread>

namespace raymarch::tests
{
namespace
{

constexpr const char* prompt = "raymarch> ";

/// Runs the console at its own terminal.
class Terminal
{
  public:
    Terminal(const std::vector<std::string>& options, const Environment& environment)
    {
        master_ = UniqueFd(::posix_openpt(O_RDWR | O_NOCTTY | O_CLOEXEC));
        std::array<char, 64> name{};
        ::grantpt(master_.get());
        ::unlockpt(master_.get());
        ::ptsname_r(master_.get(), name.data(), name.size());
        held_ = UniqueFd(::open(name.data(), O_RDWR | O_NOCTTY | O_CLOEXEC));
        before_ = settings();
        // The terminal controls a new session, so Ctrl-C is a signal.
        std::vector<std::string> words = {RAYMARCHCTL, "console"};
#ifdef RAYMARCH_EMULATOR
        const std::vector<std::string> emulator = {RAYMARCH_EMULATOR};
        words.insert(words.begin(), emulator.begin(), emulator.end());
#endif
        words.insert(words.end(), options.begin(), options.end());
        std::vector<std::string> variables = {"TERM=xterm"};
        for (const auto& [key, value] : environment)
            variables.push_back(key + "=" + value);
        for (const char* const sanitizer : {"ASAN_OPTIONS", "LSAN_OPTIONS", "TSAN_OPTIONS"})
            if (const char* const value = ::getenv(sanitizer); value != nullptr)
                variables.push_back(std::string(sanitizer) + "=" + value);
        std::vector<char*> arguments;
        for (std::string& word : words)
            arguments.push_back(word.data());
        arguments.push_back(nullptr);
        std::vector<char*> set;
        for (std::string& variable : variables)
            set.push_back(variable.data());
        set.push_back(nullptr);
        pid_ = ::fork();
        if (pid_ == 0) {
            ::setsid();
            const int slave = ::open(name.data(), O_RDWR);
            ::ioctl(slave, TIOCSCTTY, 0);
            for (const int fd : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
                ::dup2(slave, fd);
            ::execve(arguments[0], arguments.data(), set.data());
            ::_exit(127);
        }
    }
    Terminal(const Terminal&) = delete;
    Terminal& operator=(const Terminal&) = delete;
    ~Terminal()
    {
        if (pid_ > 0) {
            ::kill(pid_, SIGKILL);
            ::waitpid(pid_, nullptr, 0);
        }
    }

    void type(std::string_view bytes) const
    {
        write_all(master_.get(), bytes);
    }
    void signal(int number) const
    {
        ::kill(pid_, number);
    }

    /// Waits until `text` is shown after the last text that was waited for.
    [[nodiscard]] bool shows(std::string_view text)
    {
        const auto deadline = std::chrono::steady_clock::now() + patience;
        while (std::chrono::steady_clock::now() < deadline) {
            if (const std::size_t at = shown_.find(text, seen_); at != std::string::npos) {
                seen_ = at + text.size();
                return true;
            }
            pump();
        }
        return false;
    }

    /// Returns the exit status, or 128 plus the signal that ended it.
    [[nodiscard]] int wait()
    {
        int raw = 0;
        const bool ended = eventually([&] {
            pump();
            return ::waitpid(pid_, &raw, WNOHANG) == pid_;
        });
        if (!ended)
            return -1;
        pid_ = -1;
        return WIFEXITED(raw) ? WEXITSTATUS(raw) : 128 + WTERMSIG(raw);
    }

    [[nodiscard]] const std::string& shown() const
    {
        return shown_;
    }

    /// Returns whether the terminal has its old settings.
    [[nodiscard]] bool restored() const
    {
        const termios now = settings();
        return now.c_lflag == before_.c_lflag && now.c_iflag == before_.c_iflag &&
               now.c_oflag == before_.c_oflag;
    }

  private:
    [[nodiscard]] termios settings() const
    {
        termios now = {};
        ::tcgetattr(held_.get(), &now);
        return now;
    }

    void pump()
    {
        pollfd waiting = {.fd = master_.get(), .events = POLLIN, .revents = 0};
        if (::poll(&waiting, 1, 20) > 0)
            shown_ += read_bytes(master_.get());
    }

    UniqueFd master_;
    UniqueFd held_;
    termios before_{};
    pid_t pid_ = -1;
    std::string shown_;
    std::size_t seen_ = 0;
};

class ConsoleAtATerminal : public testing::Test
{
  protected:
    void SetUp() override { ASSERT_TRUE(service.ready()); }

    [[nodiscard]] Environment environment() const
    {
        return {{"XDG_STATE_HOME", folder / "state"}, {"LC_ALL", "C"}};
    }
    [[nodiscard]] std::string history() const
    {
        std::ostringstream text;
        text << std::ifstream(folder / "state/raymarchctl_history").rdbuf();
        return text.str();
    }
    [[nodiscard]] std::vector<std::string> options() const
    {
        return {"--socket", service.control()};
    }

    TemporaryFolder folder;
    Service service{folder};
};

struct Typed
{
    std::string_view line;
    std::string_view reply; ///< the beginning of the reply
};
using namespace std::string_view_literals;
constexpr std::array typed_rows = {
    Typed{"SET FX=\xE2\x88\x92"
          "0.5",
          "ERR BAD_BYTE col=8 "}, // a minus of Unicode
    Typed{"SET ZM=1\xC2\xA0"
          "0",
          "ERR BAD_BYTE col=9 "}, // a no-break space
    Typed{"SET ZM=1\xE2\x80\x89"
          "0",
          "ERR BAD_BYTE col=9 "}, // a thin space
    Typed{"SET ZM=1\xEF\xBB\xBF"
          "0",
          "ERR BAD_BYTE col=9 "}, // a byte order mark
    Typed{"SET ZM=1\xF0\x9F\x98\x80"
          "0",
          "ERR BAD_BYTE col=9 "},
    Typed{"SET ZM=1\xE4"
          "0",
          "ERR BAD_BYTE col=9 "}, // Latin-1
    Typed{"SET ZM=1\x96"
          "0",
          "ERR BAD_BYTE col=9 "},
    Typed{"SET ZM=1\xC2\x85"
          "0",
          "ERR BAD_BYTE col=9 "}, // a control character of Unicode
    Typed{"SET ZM=1\xED\xA0\x80"
          "0",
          "ERR BAD_BYTE col=9 "}, // half a surrogate pair
    Typed{"SET ZM=1\xC0\xB0"
          "0",
          "ERR BAD_BYTE col=9 "}, // an over-long form
    Typed{"SET ZM=1\xF4\x8F\x80\xB0"
          "0",
          "ERR BAD_BYTE col=9 "}, // a private character
    Typed{"SET ZM=1\0"
          "0"sv,
          "ERR BAD_BYTE col=9 "},
    Typed{"GET\tZM", "OK ZM=3"},
    Typed{"SET\tZM=3", "OK seq="},
};

TEST_F(ConsoleAtATerminal, NoByteIsLost)
{
    Terminal terminal(options(), environment());
    for (const Typed& row : typed_rows) {
        ASSERT_TRUE(terminal.shows(prompt)) << terminal.shown();
        terminal.type(row.line);
        terminal.type("\r");
        EXPECT_TRUE(terminal.shows("\n" + std::string(row.reply)))
            << testing::PrintToString(row.line) << terminal.shown();
    }
    terminal.type("\x04");
    EXPECT_EQ(terminal.wait(), EX_OK);
    EXPECT_TRUE(terminal.restored());
    EXPECT_EQ(service.words(), std::vector<std::uint32_t>({0x01804028, 0x03000000, 0, 0x07FFFFFF,
                                                           0x7FFFC000, 0x3FF, 0x1FFF, 0xF00003FF}));
}

TEST(ConsoleOfAPipe, NoByteIsLost)
{
    const TemporaryFolder folder;
    const Service service(folder);
    ASSERT_TRUE(service.ready());
    for (const std::string ending : {"\n", "\r\n"}) {
        std::string input;
        for (const Typed& row : typed_rows)
            input += std::string(row.line) + ending;
        const Finished console =
            run_tool(folder, {"console", "--socket", service.control()}, input);
        EXPECT_EQ(console.status, 1) << console.errors;
        std::istringstream replies(console.output);
        for (const Typed& row : typed_rows) {
            std::string reply;
            std::getline(replies, reply);
            EXPECT_TRUE(reply.starts_with(row.reply))
                << testing::PrintToString(row.line) << ": " << reply;
        }
    }
}

TEST_F(ConsoleAtATerminal, QuitAndExitEndIt)
{
    for (const std::string word : {"quit", "exit", "QUIT", " Exit\t"}) {
        Terminal terminal(options(), environment());
        ASSERT_TRUE(terminal.shows("quit, exit or Ctrl-D ends the console.")) << terminal.shown();
        ASSERT_TRUE(terminal.shows(prompt));
        terminal.type(word + "\r");
        EXPECT_EQ(terminal.wait(), EX_OK) << word;
        EXPECT_TRUE(terminal.restored());
        EXPECT_EQ(terminal.shown().find("ERR"), std::string::npos) << terminal.shown();
    }
    EXPECT_EQ(service.status("rejected"), "0");
}

TEST_F(ConsoleAtATerminal, AQuestionMarkIsHelp)
{
    Terminal terminal(options(), environment());
    ASSERT_TRUE(terminal.shows("HELP or ? shows the commands"));
    ASSERT_TRUE(terminal.shows(prompt));
    terminal.type("?\r");
    EXPECT_TRUE(terminal.shows("# A frame is KEY=VALUE")) << terminal.shown();
    EXPECT_TRUE(terminal.shows("# HELP with a command")) << terminal.shown();
    // Longer lines with these words go to the service.
    for (const std::string line : {"quit now", "exits", "??", "? ZM", "exit=1"}) {
        ASSERT_TRUE(terminal.shows(prompt));
        terminal.type(line + "\r");
        EXPECT_TRUE(terminal.shows("\nERR ")) << line << terminal.shown();
    }
    ASSERT_TRUE(terminal.shows(prompt));
    terminal.type("\x04");
    EXPECT_EQ(terminal.wait(), EX_OK);
}

TEST(ConsoleOfAPipe, ItsWordsAreTheServices)
{
    const TemporaryFolder folder;
    const Service service(folder);
    ASSERT_TRUE(service.ready());
    const Finished console =
        run_tool(folder, {"console", "--socket", service.control()}, "quit\nexit\n?\nPING\n");
    EXPECT_EQ(console.status, 1);
    std::istringstream replies(console.output);
    std::string reply;
    for (int i = 0; i < 3; ++i) {
        std::getline(replies, reply);
        EXPECT_TRUE(reply.starts_with("ERR UNKNOWN_COMMAND col=1")) << reply;
    }
    std::getline(replies, reply);
    EXPECT_EQ(reply, "OK");
}

TEST(ConsoleOfAPipe, BlankLinesAndCommentsHaveNoReplyAndTheLastLineMayHaveNoEnding)
{
    const TemporaryFolder folder;
    const Service service(folder);
    ASSERT_TRUE(service.ready());
    const Finished console = run_tool(folder, {"console", "--socket", service.control()},
                                      "\r\nPING\r\n\r\n \t\r\n\n# a comment\r\nOK\r\nGET ZM");
    EXPECT_EQ(console.status, EX_OK) << console.errors;
    EXPECT_EQ(console.output, "OK\nOK ZM=3\n");
    const Finished longest = run_tool(folder, {"console", "--socket", service.control()},
                                      std::string(1'000'000, 'x') + "\nPING");
    EXPECT_TRUE(longest.output.starts_with("ERR TOO_LONG : ")) << longest.output;
    EXPECT_TRUE(longest.output.ends_with("\nOK\n")) << longest.output;
}

/// This includes text that is typed before the prompt or before a reply. A terminal in line mode
/// would cut a line after 4095 bytes.
TEST_F(ConsoleAtATerminal, WhatIsTypedAheadIsNotLost)
{
    Terminal terminal(options(), environment());
    ASSERT_TRUE(terminal.shows(prompt));
    std::string text = "PING\r";
    for (int i = 0; i < 500; ++i)
        text += "SET\tZM=1\xC2\xA0"
                "0\r";
    text += std::string(1024, 'x') + "\rGET ZM\r\x04";
    std::thread typist([&] { terminal.type(text); });
    for (int i = 0; i < 500; ++i)
        if (!terminal.shows("ERR BAD_BYTE col=9")) {
            ADD_FAILURE() << i << terminal.shown();
            break;
        }
    EXPECT_TRUE(terminal.shows("ERR UNKNOWN_COMMAND col=1"));
    EXPECT_TRUE(terminal.shows("OK ZM=3"));
    typist.join();
    EXPECT_EQ(terminal.wait(), EX_OK);
    EXPECT_TRUE(terminal.restored());
}

TEST_F(ConsoleAtATerminal, ACompletedWordGetsItsBlank)
{
    Terminal terminal(options(), environment());
    ASSERT_TRUE(terminal.shows(prompt));
    terminal.type("HEL\t");
    ASSERT_TRUE(terminal.shows("P ")) << terminal.shown();
    terminal.type("PIN\t");
    ASSERT_TRUE(terminal.shows("G ")) << terminal.shown();
    terminal.type("\r");
    ASSERT_TRUE(terminal.shows("# PING")) << terminal.shown();
    ASSERT_TRUE(terminal.shows(prompt));
    terminal.type("SET OB\t");
    ASSERT_TRUE(terminal.shows("J=")) << terminal.shown();
    terminal.type("cu\t");
    ASSERT_TRUE(terminal.shows("be ")) << terminal.shown();
    terminal.type("\r");
    ASSERT_TRUE(terminal.shows("OK seq=1 changed=1")) << terminal.shown();
}

TEST_F(ConsoleAtATerminal, CtrlCDropsTheLineAndNotTheHistory)
{
    Terminal terminal(options(), environment());
    ASSERT_TRUE(terminal.shows(prompt));
    terminal.type("GET ZM\r");
    ASSERT_TRUE(terminal.shows("OK ZM=3"));
    ASSERT_TRUE(terminal.shows(prompt));
    terminal.type("SET ZM=");
    ASSERT_TRUE(terminal.shows("SET ZM="));
    terminal.type("\x03");
    ASSERT_TRUE(terminal.shows("^C"));
    ASSERT_TRUE(terminal.shows(prompt));
    terminal.type("PING\r");
    ASSERT_TRUE(terminal.shows("\nOK\r")) << terminal.shown();
    ASSERT_TRUE(terminal.shows(prompt));
    terminal.type("\x04");
    EXPECT_EQ(terminal.wait(), EX_OK);
    EXPECT_EQ(history(), "_HiStOrY_V2_\nGET\\040ZM\nPING\n");
}

TEST_F(ConsoleAtATerminal, ASignalEndsItWithItsHistory)
{
    for (const int number : {SIGTERM, SIGHUP}) {
        std::filesystem::remove_all(folder / "state");
        Terminal terminal(options(), environment());
        ASSERT_TRUE(terminal.shows(prompt));
        terminal.type("GET ZM\r");
        ASSERT_TRUE(terminal.shows("OK ZM=3"));
        ASSERT_TRUE(terminal.shows(prompt));
        terminal.signal(number);
        EXPECT_EQ(terminal.wait(), 128 + number);
        EXPECT_TRUE(terminal.restored());
        EXPECT_EQ(history(), "_HiStOrY_V2_\nGET\\040ZM\n");
    }
}

TEST_F(ConsoleAtATerminal, ALostServiceEndsItWithItsHistory)
{
    Terminal terminal(options(), environment());
    ASSERT_TRUE(terminal.shows(prompt));
    terminal.type("GET ZM\r");
    ASSERT_TRUE(terminal.shows("OK ZM=3"));
    ASSERT_TRUE(terminal.shows(prompt));
    service.process.signal(SIGTERM);
    ASSERT_EQ(service.process.wait(), 0);
    terminal.type("PING\r");
    EXPECT_TRUE(terminal.shows("the service closed the connection")) << terminal.shown();
    EXPECT_EQ(terminal.wait(), EX_IOERR);
    EXPECT_TRUE(terminal.restored());
    EXPECT_EQ(history(), "_HiStOrY_V2_\nGET\\040ZM\nPING\n");
}

TEST_F(ConsoleAtATerminal, CtrlCEndsAWaitForAReply)
{
    // It answers the first contact, and then is silent.
    std::atomic<bool> asked = false;
    const FarEnd line(folder, FarEnd::Place::Socket, [&](int fd) {
        Host host = Host::on_socket(service.control());
        answers([&](const std::string& text) {
            asked = asked || text == "REGS";
            return asked ? std::string() : host.ask(text) + "\r\n";
        })(fd);
    });
    Terminal terminal(line.options(), environment());
    ASSERT_TRUE(terminal.shows(prompt));
    terminal.type("REGS\r");
    ASSERT_TRUE(eventually([&] { return asked.load(); }));
    terminal.type("\x03");
    EXPECT_EQ(terminal.wait(), 128 + SIGINT);
    EXPECT_TRUE(terminal.restored());
    EXPECT_EQ(history(), "_HiStOrY_V2_\nREGS\n");
}

TEST_F(ConsoleAtATerminal, AnEmptyOrRelativeStateFolderIsNone)
{
    for (const std::string state : {"", "state", "./state"}) {
        std::filesystem::remove_all(folder / "home");
        Terminal terminal(options(), {{"XDG_STATE_HOME", state}, {"HOME", folder / "home"}});
        ASSERT_TRUE(terminal.shows(prompt));
        terminal.type("PING\r");
        ASSERT_TRUE(terminal.shows("\nOK\r"));
        ASSERT_TRUE(terminal.shows(prompt));
        terminal.type("\x04");
        EXPECT_EQ(terminal.wait(), EX_OK);
        EXPECT_TRUE(std::filesystem::exists(folder / "home/.local/state/raymarchctl_history"));
    }
    Terminal homeless(options(), {});
    ASSERT_TRUE(homeless.shows(prompt));
    homeless.type("PING\r\x04");
    EXPECT_TRUE(homeless.shows("\nOK\r"));
    EXPECT_EQ(homeless.wait(), EX_OK);
}

} // namespace
} // namespace raymarch::tests
