// SPDX-License-Identifier: MIT
/// @file
/// Tells what exists at a path that is about to be read or written. Everybody who opens a file asks
/// first, so that no device, FIFO or link is taken for an ordinary file.
#pragma once

#include "base/result.hpp"

#include <sys/stat.h>

#include <optional>
#include <string>

namespace raymarch
{

/// The place at which a file is to be written.
struct FileTarget
{
    std::string path;                  ///< after all symbolic links were followed
    std::optional<struct ::stat> file; ///< empty if there is no file yet
};

/// Follows symbolic links. A dangling link gives the path at which its file would be made. The
/// kernel decides whether a link may be followed; it is strict in folders such as /tmp.
/// Errors: InputOutput if the path is not an ordinary file, if links form a loop, or if the path is
/// an open file that has no name any more.
[[nodiscard]] Result<FileTarget> find_target(const std::string& path);

/// The error for a path that is not an ordinary file:
/// "PATH is a FIFO, not a file".
[[nodiscard]] Error not_a_file(const std::string& path, mode_t mode);

/// The most symbolic links that Linux follows in a row.
inline constexpr int most_links = 40;

/// The path at which a chain of symbolic links ends; `path` itself if it is not a link.
[[nodiscard]] std::string end_of_links(const std::string& path);

} // namespace raymarch
