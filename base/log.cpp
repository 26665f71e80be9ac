// SPDX-License-Identifier: MIT
#include "base/log.hpp"

#include "base/unique_fd.hpp"

#include <fcntl.h>
#include <poll.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <charconv>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <mutex>
#include <new>
#include <utility>

namespace raymarch::log
{
namespace
{

struct Name
{
    std::string_view name;
    Level level;
};
constexpr std::array names = {
    Name{"error", Level::Error}, Name{"warning", Level::Warning}, Name{"notice", Level::Notice},
    Name{"info", Level::Info},   Name{"debug", Level::Debug},
};

std::atomic<Level> threshold = Level::Notice;

/// systemd sets JOURNAL_STREAM for a service if its standard error goes to the journal.
bool journal_reads() noexcept
{
    static const bool result =
        std::getenv("JOURNAL_STREAM") != nullptr; // NOLINT(concurrency-mt-unsafe)
    return result;
}

/// Returns whether a byte of a message would end the line or control a terminal. UTF-8 writes the
/// control characters above 0x7F as C2 80 to C2 9F.
bool is_control(unsigned char byte, unsigned char before) noexcept
{
    return byte < 0x20 || byte == 0x7F || (before == 0xC2 && byte >= 0x80 && byte < 0xA0);
}

/// Builds one line in a buffer.
class Line
{
  public:
    explicit Line(Level level) noexcept
    {
        const std::array<char, 3> priority = {'<', static_cast<char>('0' + static_cast<int>(level)),
                                              '>'};
        if (journal_reads())
            add({priority.data(), priority.size()});
        else
            add("raymarchd: ");
    }
    void add(std::string_view text) noexcept
    {
        unsigned char before = 0;
        for (const char c : text) {
            const auto byte = static_cast<unsigned char>(c);
            if (is_control(byte, std::exchange(before, byte))) {
                constexpr std::string_view digits = "0123456789abcdef";
                const std::array shown = {'\\', 'x', digits[byte >> 4], digits[byte & 0xF]};
                put({shown.data(), shown.size()});
            } else {
                put({&c, 1});
            }
        }
    }
    void add(std::uint64_t number) noexcept
    {
        std::array<char, 20> digits{};
        const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), number).ptr;
        put({digits.data(), static_cast<std::size_t>(end - digits.data())});
    }
    /// Returns the line with its ending.
    [[nodiscard]] std::string_view end() noexcept
    {
        const std::string_view ending = cut_ ? "...\n" : "\n";
        std::copy(ending.begin(), ending.end(), bytes_.data() + size_);
        return {bytes_.data(), size_ + ending.size()};
    }

  private:
    void put(std::string_view piece) noexcept
    {
        constexpr std::size_t for_ending = 4;
        cut_ = cut_ || size_ + piece.size() > bytes_.size() - for_ending;
        if (cut_)
            return;
        std::copy(piece.begin(), piece.end(), bytes_.data() + size_);
        size_ += piece.size();
    }
    std::array<char, longest_line> bytes_; // NOLINT(*-member-init): written before it is read
    std::size_t size_ = 0;
    bool cut_ = false;
};

/// Writes to standard error without blocking. It checks for each line which file the descriptor
/// leads to, because a test may redirect it while the program runs.
class Output
{
  public:
    /// Returns how many bytes were written, possibly none.
    std::size_t write(std::string_view bytes) noexcept
    {
        struct stat info = {};
        if (::fstat(STDERR_FILENO, &info) != 0)
            return bytes.size(); // the descriptor is closed, so nobody could read the line
        ssize_t sent = -1;
        if (S_ISSOCK(info.st_mode))
            sent = ::send(STDERR_FILENO, bytes.data(), bytes.size(), MSG_DONTWAIT | MSG_NOSIGNAL);
        else if (S_ISFIFO(info.st_mode) || S_ISCHR(info.st_mode))
            sent = write_unblocked(info, bytes);
        else // a file, whose writes never wait for a reader
            sent = ::write(STDERR_FILENO, bytes.data(), bytes.size());
        return sent > 0 ? static_cast<std::size_t>(sent) : 0;
    }

  private:
    /// O_NONBLOCK belongs to the open file description, which other processes share. So a pipe or
    /// a terminal is opened a second time, and only that description does not block.
    ssize_t write_unblocked(const struct stat& info, std::string_view bytes) noexcept
    {
        if (own_ && (info.st_dev != device_ || info.st_ino != number_))
            own_.reset();
        if (!own_) {
            device_ = info.st_dev;
            number_ = info.st_ino;
            own_ =
                UniqueFd(::open("/proc/self/fd/2", O_WRONLY | O_NONBLOCK | O_NOCTTY | O_CLOEXEC));
        }
        if (own_)
            return ::write(own_.get(), bytes.data(), bytes.size());
        // It cannot be opened again (another user's terminal, no /proc), so poll() tells whether
        // there is room. If a pipe has room at all, it has room for a whole line.
        pollfd end = {.fd = STDERR_FILENO, .events = POLLOUT, .revents = 0};
        if (::poll(&end, 1, 0) != 1 || (end.revents & POLLOUT) == 0)
            return 0;
        return ::write(STDERR_FILENO, bytes.data(), bytes.size());
    }

    UniqueFd own_;
    dev_t device_ = 0;
    ino_t number_ = 0;
};

/// Writes the lines of all threads in the order in which they come.
class Writer
{
  public:
    void write(Level level, std::string_view text) noexcept
    {
        const std::scoped_lock lock(mutex_);
        if (lost_ > 0 && !write_lost()) {
            ++lost_;
            return;
        }
        Line line(level);
        line.add(text);
        if (!put(line.end()))
            ++lost_;
    }

  private:
    bool write_lost() noexcept
    {
        Line line(Level::Warning);
        line.add(lost_);
        line.add(lost_ == 1 ? " line of the log was lost" : " lines of the log were lost");
        if (!put(line.end()))
            return false;
        lost_ = 0;
        return true;
    }
    /// A line that was written only in part counts as dropped. The next line then starts with LF.
    bool put(std::string_view line) noexcept
    {
        if (partial_ && output_.write("\n") == 0)
            return false;
        partial_ = false;
        const std::size_t sent = output_.write(line);
        partial_ = sent > 0 && sent < line.size();
        return sent == line.size();
    }

    std::mutex mutex_;
    Output output_;
    std::uint64_t lost_ = 0;
    bool partial_ = false;
};

/// The writer is never destroyed, because a thread may log until the process ends.
Writer& writer() noexcept
{
    alignas(Writer) static std::array<std::byte, sizeof(Writer)> place;
    static Writer* const only = ::new (place.data()) Writer;
    return *only;
}

} // namespace

std::optional<Level> level_named(std::string_view name) noexcept
{
    for (const Name& row : names)
        if (row.name == name)
            return row.level;
    return std::nullopt;
}

void set_level(Level level) noexcept
{
    threshold = level;
}

bool enabled(Level level) noexcept
{
    return level <= threshold.load();
}

void write_line(Level level, std::string_view text) noexcept
{
    writer().write(level, text);
}

} // namespace raymarch::log
