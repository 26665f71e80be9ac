// SPDX-License-Identifier: MIT
/// @file
/// Writes log lines to standard error. A line begins with its priority, "<N>", if it goes to the
/// journal. An error is logged once, where it is handled.
///
/// Logging never blocks. A line that does not fit into the pipe is dropped, and the number of
/// dropped lines is logged before the next line that fits.
#pragma once

#include <fmt/core.h>

#include <cstddef>
#include <optional>
#include <string_view>
#include <utility>

namespace raymarch::log
{

/// The priorities of syslog. The number stands between the brackets of "<N>".
enum class Level { Error = 3, Warning = 4, Notice = 5, Info = 6, Debug = 7 };

/// Returns the level that a word from "error" to "debug" names; empty for any other word.
[[nodiscard]] std::optional<Level> level_named(std::string_view name) noexcept;

/// This is the longest line, with prefix and ending. A write of this size to a pipe is atomic.
inline constexpr std::size_t longest_line = 4096;

/// Drops lines that are less important than `level` from now on. The default is Notice.
void set_level(Level level) noexcept;
[[nodiscard]] bool enabled(Level level) noexcept;

/// Writes one line with a single system call and allocates nothing. Bytes that would end the line
/// or control a terminal are written as \xHH, so that a name from outside cannot forge a line. A
/// line longer than longest_line is cut and ends in "...". Any thread may call this function.
void write_line(Level level, std::string_view text) noexcept;

template <typename... Args>
void line(Level level, fmt::format_string<Args...> format, Args&&... args)
{
    if (enabled(level))
        write_line(level, fmt::format(format, std::forward<Args>(args)...));
}

template <typename... Args>
void error(fmt::format_string<Args...> format, Args&&... args)
{
    line(Level::Error, format, std::forward<Args>(args)...);
}
template <typename... Args>
void warning(fmt::format_string<Args...> format, Args&&... args)
{
    line(Level::Warning, format, std::forward<Args>(args)...);
}
template <typename... Args>
void notice(fmt::format_string<Args...> format, Args&&... args)
{
    line(Level::Notice, format, std::forward<Args>(args)...);
}
template <typename... Args>
void info(fmt::format_string<Args...> format, Args&&... args)
{
    line(Level::Info, format, std::forward<Args>(args)...);
}
template <typename... Args>
void debug(fmt::format_string<Args...> format, Args&&... args)
{
    line(Level::Debug, format, std::forward<Args>(args)...);
}

} // namespace raymarch::log
