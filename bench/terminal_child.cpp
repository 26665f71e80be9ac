// SPDX-License-Identifier: MIT
#include "bench/terminal_child.hpp"

#include <fcntl.h>
#include <signal.h>
#include <stdlib.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <chrono>
#include <thread>

namespace raymarch::bench
{
namespace
{

namespace fs = std::filesystem;
using namespace std::chrono_literals;

constexpr std::size_t page_bytes = 4096;
constexpr auto start_limit = 5s;
constexpr auto end_limit = 2s;

/// Asks again each millisecond; false when `done` has not come true within `limit`.
template <typename Done>
bool poll_until(std::chrono::milliseconds limit, Done done)
{
    const auto end = std::chrono::steady_clock::now() + limit;
    while (!done()) {
        if (std::chrono::steady_clock::now() >= end)
            return false;
        std::this_thread::sleep_for(1ms);
    }
    return true;
}

std::string replaced(std::string word, std::string_view mark, const fs::path& path)
{
    if (const auto at = word.find(mark); at != std::string::npos)
        word.replace(at, mark.size(), path.string());
    return word;
}

/// In the child, between fork and exec: only calls that are safe there.
[[noreturn]] void execute(char* const* arguments)
{
    ::prctl(PR_SET_PDEATHSIG, SIGKILL); // a measurement that dies leaves nothing behind
    const int nowhere = ::open("/dev/null", O_RDWR);
    ::dup2(nowhere, STDIN_FILENO);
    ::dup2(nowhere, STDOUT_FILENO);
    ::execvp(arguments[0], arguments);
    ::_exit(127);
}

} // namespace

Result<TemporaryFolder> TemporaryFolder::make()
{
    std::string path = (fs::temp_directory_path() / "raymarch-bench-XXXXXX").string();
    if (::mkdtemp(path.data()) == nullptr)
        return fail(errno_error(ErrorKind::InputOutput, "make", path));
    return TemporaryFolder(path);
}

TemporaryFolder::~TemporaryFolder()
{
    std::error_code error;
    if (!path_.empty())
        fs::remove_all(path_, error);
}

Result<void> TerminalChild::map_registers(const fs::path& path)
{
    const UniqueFd fd(::open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0600));
    if (!fd || ::ftruncate(fd.get(), page_bytes) != 0)
        return fail(errno_error(ErrorKind::InputOutput, "make", path.string()));
    void* const page = ::mmap(nullptr, page_bytes, PROT_READ, MAP_SHARED, fd.get(), 0);
    if (page == MAP_FAILED)
        return fail(errno_error(ErrorKind::InputOutput, "map", path.string()));
    page_ = static_cast<const volatile std::uint32_t*>(page);
    return {};
}

bool TerminalChild::ended() noexcept
{
    if (pid_ > 0 && ::waitpid(pid_, nullptr, WNOHANG) == pid_)
        pid_ = -1;
    return pid_ <= 0;
}

Result<void> TerminalChild::open_terminal(const fs::path& link)
{
    poll_until(start_limit, [&] {
        terminal_ = UniqueFd(::open(link.c_str(), O_RDWR | O_NOCTTY | O_NONBLOCK | O_CLOEXEC));
        return terminal_ || ended();
    });
    if (!terminal_)
        return fail(plain_error(ErrorKind::Unavailable, "no terminal at " + link.string()));
    return {};
}

Result<std::unique_ptr<TerminalChild>> TerminalChild::start(const std::vector<std::string>& command,
                                                            const fs::path& folder)
{
    const fs::path registers = folder / "registers";
    const fs::path link = folder / "terminal";
    std::unique_ptr<TerminalChild> child(new TerminalChild);
    if (auto mapped = child->map_registers(registers); !mapped)
        return fail(mapped.error());

    std::vector<std::string> words;
    words.reserve(command.size());
    for (const std::string& word : command)
        words.push_back(replaced(replaced(word, "{registers}", registers), "{link}", link));
    std::vector<char*> arguments;
    arguments.reserve(words.size() + 1);
    for (std::string& word : words)
        arguments.push_back(word.data());
    arguments.push_back(nullptr);

    child->pid_ = ::fork();
    if (child->pid_ == 0)
        execute(arguments.data());
    if (child->pid_ < 0)
        return fail(errno_error(ErrorKind::InputOutput, "start", words.front()));
    if (auto opened = child->open_terminal(link); !opened)
        return fail(
            plain_error(ErrorKind::Unavailable, words.front() + ": " + opened.error().message));
    return child;
}

TerminalChild::~TerminalChild()
{
    terminal_.reset();
    if (!ended()) {
        ::kill(pid_, SIGTERM);
        if (!poll_until(end_limit, [this] { return ended(); })) {
            ::kill(pid_, SIGKILL);
            ::waitpid(pid_, nullptr, 0);
        }
    }
    if (page_ != nullptr)
        ::munmap(const_cast<std::uint32_t*>(page_), page_bytes);
}

bool TerminalChild::write(std::string_view bytes) noexcept
{
    return ::write(terminal_.get(), bytes.data(), bytes.size()) ==
           static_cast<ssize_t>(bytes.size());
}

void TerminalChild::drain() noexcept
{
    std::array<char, 4096> bytes; // NOLINT(*-member-init): thrown away
    while (::read(terminal_.get(), bytes.data(), bytes.size()) > 0) {
    }
}

} // namespace raymarch::bench
