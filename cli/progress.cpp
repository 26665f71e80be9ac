// SPDX-License-Identifier: MIT
#include "cli/progress.hpp"

#include <fmt/format.h>

#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <cstdint>
#include <string_view>

namespace raymarch::cli
{
namespace
{

constexpr std::chrono::milliseconds shortest_wait{100};
constexpr unsigned widest_bar = 40;
constexpr unsigned usual_columns = 80; ///< for a terminal that does not report its width
constexpr std::string_view clear_line = "\r\x1B[K";

std::string as_text(std::chrono::seconds time)
{
    const auto seconds = time.count();
    return seconds < 3600
               ? fmt::format("{}:{:02}", seconds / 60, seconds % 60)
               : fmt::format("{}:{:02}:{:02}", seconds / 3600, seconds / 60 % 60, seconds % 60);
}

unsigned terminal_columns()
{
    winsize size{};
    return ::ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0 ? size.ws_col
                                                                             : usual_columns;
}

/// Does not use stdio, because a full terminal would set its error flag. Lost text does no harm.
void write_error(std::string_view text)
{
    static_cast<void>(!::write(STDERR_FILENO, text.data(), text.size()));
}

} // namespace

std::string progress_line(unsigned done, unsigned total, std::string_view unit,
                          std::chrono::seconds left, unsigned columns)
{
    const auto parts = [&](unsigned of) {
        return static_cast<unsigned>(std::uint64_t{of} * done / total);
    };
    std::string text = fmt::format("{}/{} {}  {} %", done, total, unit, parts(100));
    if (done > 0)
        text += fmt::format("  {} left", as_text(left));
    const std::size_t beside = text.size() + 3; // the brackets and a space
    if (columns > beside) {
        const unsigned bar = std::min(widest_bar, columns - static_cast<unsigned>(beside));
        text = fmt::format("[{:<{}}] {}", std::string(parts(bar), '#'), bar, text);
    }
    return text.substr(0, columns);
}

Progress::Progress(unsigned total, std::string_view unit, std::chrono::milliseconds quiet)
    : total_(total)
    , unit_(unit)
    , quiet_(quiet)
    , visible_(::isatty(STDERR_FILENO) == 1)
    , start_(Clock::now())
{
    show(0);
}

Progress::~Progress()
{
    if (drawn_once_)
        write_error(clear_line);
}

void Progress::show(unsigned done)
{
    const auto now = Clock::now();
    if (!visible_ || now - start_ < quiet_ || (done < total_ && now - drawn_ < shortest_wait))
        return;
    drawn_ = now;
    drawn_once_ = true;
    const auto left =
        done > 0 ? (now - start_) * (total_ - done) / done : std::chrono::nanoseconds::zero();
    // The last column stays free, because some terminals begin a new line after it.
    const std::string line = progress_line(
        done, total_, unit_, std::chrono::ceil<std::chrono::seconds>(left), terminal_columns() - 1);
    write_error(std::string(clear_line) + line);
}

} // namespace raymarch::cli
