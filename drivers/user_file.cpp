// SPDX-License-Identifier: MIT
#include "drivers/user_file.hpp"

#include "base/file_target.hpp"
#include "base/unique_fd.hpp"
#include "drivers/atomic_file.hpp"

#include <fcntl.h>
#include <poll.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <charconv>
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <optional>
#include <system_error>

namespace raymarch::drivers
{
namespace
{

namespace fs = std::filesystem;
using std::chrono::milliseconds;

constexpr const char* standard_stream = "-";
constexpr milliseconds no_timeout{-1}; ///< the value that poll() expects

struct Direction
{
    int flags;
    int standard_fd;
    const char* standard_name;
    milliseconds timeout; ///< for the other end of a FIFO or a device
};
constexpr Direction output{O_WRONLY, STDOUT_FILENO, "standard output", milliseconds{30'000}};
constexpr Direction input{O_RDONLY, STDIN_FILENO, "standard input", milliseconds{5'000}};

struct Stream
{
    UniqueFd owned; ///< empty if the descriptor was open before
    int fd;
    std::string name;
    milliseconds timeout;
};

std::optional<int> number_of(const std::string& text)
{
    int number = 0;
    const char* const end = text.data() + text.size();
    const auto [stop, error] = std::from_chars(text.data(), end, number);
    return error == std::errc{} && stop == end ? std::optional(number) : std::nullopt;
}

bool same_folder(const fs::path& a, const fs::path& b)
{
    std::error_code ignored; // after an error the folders count as different
    return fs::equivalent(a.empty() ? "." : a, b, ignored);
}

/// Returns the N of /dev/fd/N, /proc/self/fd/N, /dev/stdout and links to them. To open such a name
/// would lose the position of the descriptor in its file.
std::optional<int> own_descriptor(const std::string& path)
{
    fs::path end = path;
    for (int links = 0; links < most_links; ++links) {
        if (same_folder(end.parent_path(), "/proc/self/fd"))
            return number_of(end.filename().string());
        std::error_code no_link;
        const fs::path next = fs::read_symlink(end, no_link);
        if (no_link)
            break;
        end = end.parent_path() / next;
    }
    return std::nullopt;
}

/// Opens a FIFO, a device or a descriptor. Returns nothing if `path` is a file or does not exist.
Result<std::optional<Stream>> open_stream(const std::string& path, const Direction& direction)
{
    if (path == standard_stream)
        return Stream{{}, direction.standard_fd, direction.standard_name, no_timeout};
    if (const auto own = own_descriptor(path))
        return Stream{{}, *own, path, no_timeout};
    struct stat info = {};
    if (::stat(path.c_str(), &info) != 0 || S_ISREG(info.st_mode))
        return std::nullopt;
    if (!S_ISFIFO(info.st_mode) && !S_ISCHR(info.st_mode))
        return fail(not_a_file(path, info.st_mode));
    UniqueFd fd(::open(path.c_str(), direction.flags | O_NONBLOCK | O_NOCTTY | O_CLOEXEC));
    if (!fd && errno == ENXIO && S_ISFIFO(info.st_mode))
        return fail(Error{ErrorKind::InputOutput, ENXIO, path + " is a FIFO that nobody reads"});
    if (!fd)
        return fail(errno_error(ErrorKind::InputOutput, "open", path));
    const int number = fd.get();
    return Stream{std::move(fd), number, path, direction.timeout};
}

/// Returns whether the stream has bytes, room or its end before the timeout.
bool ready(const Stream& stream, short events, milliseconds timeout)
{
    pollfd waiting = {.fd = stream.fd, .events = events, .revents = 0};
    int found = -1;
    do
        found = ::poll(&waiting, 1, static_cast<int>(timeout.count()));
    while (found < 0 && errno == EINTR);
    return found != 0;
}

Result<void> write_stream(const Stream& stream, std::span<const std::uint8_t> bytes)
{
    while (!bytes.empty()) {
        const ssize_t size = ::write(stream.fd, bytes.data(), bytes.size());
        if (size >= 0) {
            bytes = bytes.subspan(static_cast<std::size_t>(size));
            continue;
        }
        if (errno == EINTR)
            continue;
        if (errno != EAGAIN)
            return fail(errno_error(ErrorKind::InputOutput, "write", stream.name));
        if (!ready(stream, POLLOUT, stream.timeout))
            return fail(plain_error(ErrorKind::InputOutput, stream.name + ": nobody reads it"));
    }
    return {};
}

Result<std::string> read_stream(const Stream& stream, std::size_t limit)
{
    std::string content;
    std::array<char, 4096> chunk{};
    bool awaited = stream.timeout == no_timeout;
    bool came = true;
    for (;;) {
        const ssize_t size = ::read(stream.fd, chunk.data(), chunk.size());
        if (size > 0) {
            content.append(chunk.data(), static_cast<std::size_t>(size));
            if (content.size() > limit)
                return fail(plain_error(ErrorKind::BadData, stream.name + " has more than " +
                                                                std::to_string(limit) + " bytes"));
        } else if (size == 0 && content.empty() && !awaited) {
            // A FIFO without a writer is at its end, but a writer may open it soon.
            awaited = true;
            came = ready(stream, POLLIN, stream.timeout);
        } else if (size == 0) {
            if (came || !content.empty())
                return content;
            return fail(plain_error(ErrorKind::InputOutput,
                                    stream.name + " is a FIFO that nobody writes to"));
        } else if (errno == EAGAIN) { // a writer has it open
            came = ready(stream, POLLIN, no_timeout);
        } else if (errno != EINTR) {
            return fail(errno_error(ErrorKind::InputOutput, "read", stream.name));
        }
    }
}

} // namespace

Result<void> check_output(const std::string& path)
{
    if (path == standard_stream && ::isatty(STDOUT_FILENO) != 0)
        return fail(plain_error(ErrorKind::Usage,
                                "standard output is a terminal; - needs a pipe or a file"));
    struct stat info = {};
    if (path == standard_stream || own_descriptor(path) || ::stat(path.c_str(), &info) != 0 ||
        S_ISREG(info.st_mode) || S_ISCHR(info.st_mode) || S_ISFIFO(info.st_mode))
        return {};
    return fail(not_a_file(path, info.st_mode));
}

Result<void> write_output(const std::string& path, std::span<const std::uint8_t> bytes)
{
    if (auto possible = check_output(path); !possible)
        return possible;
    static_cast<void>(std::fflush(stdout)); // earlier output comes first
    const auto stream = open_stream(path, output);
    if (!stream)
        return fail(stream.error());
    if (*stream)
        return write_stream(**stream, bytes);
    return replace_file(path, bytes, Durability::BestEffort);
}

Result<std::string> read_input(const std::string& path, std::size_t limit)
{
    const auto stream = open_stream(path, input);
    if (!stream)
        return fail(stream.error());
    return *stream ? read_stream(**stream, limit) : read_file(path, limit);
}

std::string input_name(const std::string& path)
{
    return path == standard_stream ? input.standard_name : path;
}

} // namespace raymarch::drivers
