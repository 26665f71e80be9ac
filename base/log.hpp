// SPDX-License-Identifier: MIT
/// @file
/// Log lines on standard error: with a "<N>" priority when a journal reads them, without for a
/// person. Log once, where an error is handled.
///
/// Logging never waits for whoever reads. A line that finds no room is lost; how many were is said
/// with the next one that finds some.
#pragma once

#include <fmt/core.h>

#include <cstddef>
#include <optional>
#include <string_view>
#include <utility>

namespace raymarch::log
{

/// syslog priorities; the numeric value is what stands between the brackets.
enum class Level { Error = 3, Warning = 4, Notice = 5, Info = 6, Debug = 7 };

/// "error" … "debug" to a level; nothing for any other word.
[[nodiscard]] std::optional<Level> level_named(std::string_view name) noexcept;

/// With prefix and ending: as much as a pipe takes whole.
inline constexpr std::size_t longest_line = 4096;

/// Lines less important than `level` are dropped. Default: Notice.
void set_level(Level level) noexcept;
[[nodiscard]] bool enabled(Level level) noexcept;

/// Writes one line with a single system call; allocates nothing. Bytes that would end the line or
/// steer a terminal are shown as \xHH, so that no name from outside makes lines of its own. What is
/// longer than longest_line is cut, which "..." at its end shows. Any thread may call it.
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
