// SPDX-License-Identifier: MIT
#include "service/support.hpp"

#include "drivers/atomic_file.hpp"
#include "drivers/serial_port.hpp"
#include "tests/fakes/temporary_folder.hpp"

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <thread>

namespace raymarch::tests
{
namespace
{

using Clock = std::chrono::steady_clock;
namespace fs = std::filesystem;

/// The command as it is started: through the emulator when the programs are not for this machine.
std::vector<std::string> with_emulator(std::vector<std::string> command)
{
#ifdef RAYMARCH_EMULATOR
    const std::vector<std::string> emulator = {RAYMARCH_EMULATOR};
    command.insert(command.begin(), emulator.begin(), emulator.end());
#endif
    return command;
}

/// Between fork and exec only what is safe there.
[[noreturn]] void become(const std::vector<char*>& arguments, int input, int output, int errors)
{
    ::dup2(input, STDIN_FILENO);
    ::dup2(output, STDOUT_FILENO);
    ::dup2(errors, STDERR_FILENO);
    ::execv(arguments[0], arguments.data());
    ::_exit(127);
}

} // namespace

bool eventually(const std::function<bool()>& condition)
{
    const auto deadline = Clock::now() + patience;
    while (!condition()) {
        if (Clock::now() > deadline)
            return false;
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
    return true;
}

TemporaryFolder::TemporaryFolder()
{
    std::string pattern = (fs::temp_directory_path() / "raymarch-XXXXXX").string();
    if (::mkdtemp(pattern.data()) == nullptr)
        std::abort();
    path_ = pattern;
}

TemporaryFolder::~TemporaryFolder()
{
    std::error_code ignored;
    fs::remove_all(path_, ignored);
}

std::string TemporaryFolder::operator/(std::string_view name) const
{
    return path_ + "/" + std::string(name);
}

Process::Process(std::vector<std::string> command, const std::string& error_file,
                 const Environment& environment, const std::string& input_file)
    : error_file_(error_file)
{
    command = with_emulator(std::move(command));
    for (const auto& [name, value] : environment) // the test has one thread here
        ::setenv(name.c_str(), value.c_str(), 1);
    std::vector<char*> arguments;
    for (std::string& word : command)
        arguments.push_back(word.data());
    arguments.push_back(nullptr);
    const UniqueFd input(::open(input_file.c_str(), O_RDONLY | O_CLOEXEC));
    constexpr int create = O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC;
    const UniqueFd output(::open((error_file + ".out").c_str(), create, 0600));
    const UniqueFd errors(::open(error_file.c_str(), create, 0600));
    pid_ = ::fork();
    if (pid_ == 0)
        become(arguments, input.get(), output.get(), errors.get());
    for (const auto& [name, value] : environment)
        ::unsetenv(name.c_str());
}

Process::~Process()
{
    if (running()) {
        ::kill(pid_, SIGKILL);
        static_cast<void>(wait());
    }
}

void Process::signal(int number) const
{
    ::kill(pid_, number);
}

bool Process::running()
{
    if (status_ != -1)
        return false;
    int raw = 0;
    if (::waitpid(pid_, &raw, WNOHANG) != pid_)
        return true;
    status_ = WIFEXITED(raw) ? WEXITSTATUS(raw) : 128 + WTERMSIG(raw);
    return false;
}

int Process::wait()
{
    static_cast<void>(eventually([this] { return !running(); }));
    return status_;
}

std::string Process::errors() const
{
    return test::read_text(error_file_);
}

std::string Process::output() const
{
    return test::read_text(error_file_ + ".out");
}

Finished run_tool(const TemporaryFolder& folder, std::vector<std::string> arguments,
                  std::string_view input)
{
    static unsigned number = 0;
    const std::string name = folder / ("tool" + std::to_string(number++));
    std::ofstream(name + ".in", std::ios::binary) << input;
    arguments.insert(arguments.begin(), RAYMARCHCTL);
    Process process(std::move(arguments), name, {}, name + ".in");
    const int status = process.wait();
    return {status, process.output(), process.errors()};
}

namespace
{

std::vector<std::string> service_command(const TemporaryFolder& folder,
                                         const std::vector<std::string>& options,
                                         const std::string& shell)
{
    std::vector<std::string> command;
    if (!shell.empty())
        command = {"/bin/sh", "-c", shell, "sh"};
    command.emplace_back(RAYMARCHD);
    const std::array<std::pair<std::string, std::string>, 4> defaults = {{
        {"--registers", "file:" + folder / "registers"},
        {"--serial", "pty:" + folder / "tty"},
        {"--state", "none"},
        {"--control", folder / "control"},
    }};
    for (const auto& [option, value] : defaults)
        if (std::find(options.begin(), options.end(), option) == options.end())
            command.insert(command.end(), {option, value});
    command.insert(command.end(), options.begin(), options.end());
    return command;
}

} // namespace

Service::Service(const TemporaryFolder& folder, std::vector<std::string> options,
                 const Environment& environment, const std::string& shell)
    : process(service_command(folder, options, shell), folder / "log", environment)
    , folder_(folder)
{}

bool Service::ready() const
{
    return eventually([this] {
        Host host = Host::on_socket(control());
        return host.connected() && host.ask("PING") == "OK";
    });
}

bool Service::says(std::string_view text) const
{
    return eventually([&] { return count(text) > 0; });
}

std::size_t Service::count(std::string_view text) const
{
    const std::string log = process.errors();
    std::size_t times = 0;
    for (std::size_t at = 0; (at = log.find(text, at)) != std::string::npos; at += text.size())
        ++times;
    return times;
}

std::string Service::status(std::string_view field) const
{
    const std::string wanted = std::string(field) + "=";
    std::istringstream words(Host::on_socket(control()).ask("STATUS"));
    for (std::string word; words >> word;)
        if (word.starts_with(wanted))
            return word.substr(wanted.size());
    return {};
}

std::vector<std::uint32_t> Service::words() const
{
    const std::string bytes = test::read_text(registers());
    std::vector<std::uint32_t> result(8);
    if (bytes.size() >= 32)
        std::memcpy(result.data(), bytes.data(), 32); // registers are in the machine's own order
    return result;
}

Host Host::on_terminal(const std::string& path)
{
    UniqueFd fd;
    static_cast<void>(eventually([&] {
        fd = UniqueFd(::open(path.c_str(), O_RDWR | O_NOCTTY | O_NONBLOCK | O_CLOEXEC));
        return static_cast<bool>(fd);
    }));
    return Host(std::move(fd));
}

Host Host::on_socket(const std::string& path)
{
    UniqueFd fd(::socket(AF_UNIX, SOCK_STREAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0));
    sockaddr_un address = {};
    address.sun_family = AF_UNIX;
    std::copy_n(path.c_str(), std::min(path.size(), sizeof address.sun_path - 1), address.sun_path);
    if (::connect(fd.get(), reinterpret_cast<const sockaddr*>(&address), sizeof address) != 0)
        return Host(UniqueFd());
    return Host(std::move(fd));
}

void Host::send(std::string_view bytes) const
{
    while (!bytes.empty()) {
        // A service that has closed the connection must not end the test by SIGPIPE.
        ssize_t size = ::send(fd_.get(), bytes.data(), bytes.size(), MSG_NOSIGNAL);
        if (size < 0 && errno == ENOTSOCK)
            size = ::write(fd_.get(), bytes.data(), bytes.size());
        if (size < 0 && errno != EAGAIN && errno != EINTR)
            return; // the reply, if there is one, tells why
        if (size > 0) {
            bytes.remove_prefix(static_cast<std::size_t>(size));
            continue;
        }
        pollfd waiting = {.fd = fd_.get(), .events = POLLOUT, .revents = 0};
        if (::poll(&waiting, 1, 30'000) <= 0)
            return; // the test that waits for the reply fails
    }
}

std::string Host::reply()
{
    for (;;) {
        if (const std::size_t end = received_.find("\r\n"); end != std::string::npos) {
            std::string line = received_.substr(0, end);
            received_.erase(0, end + 2);
            return line;
        }
        pollfd waiting = {.fd = fd_.get(), .events = POLLIN, .revents = 0};
        const auto milliseconds = std::chrono::milliseconds(patience).count();
        std::array<char, 4096> chunk{};
        if (::poll(&waiting, 1, static_cast<int>(milliseconds)) <= 0)
            return {};
        const ssize_t size = ::read(fd_.get(), chunk.data(), chunk.size());
        if (size > 0)
            received_.append(chunk.data(), static_cast<std::size_t>(size));
        else if (size == 0 || errno != EAGAIN)
            return {};
    }
}

std::string Host::ask(std::string_view line)
{
    send(std::string(line) + "\n");
    return reply();
}

} // namespace raymarch::tests
