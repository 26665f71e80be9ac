// SPDX-License-Identifier: MIT
/// @file
/// Checks what exists at a path before it is read or written, so that no device, FIFO or link is
/// used as an ordinary file.
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
/// kernel decides whether a link may be followed, and refuses some links in folders such as /tmp.
/// Errors: InputOutput if the path is not an ordinary file, if links form a loop, or if the path is
/// an open file that has no name any more.
[[nodiscard]] Result<FileTarget> find_target(const std::string& path);

/// Makes the error for a path that is not an ordinary file: "PATH is a FIFO, not a file".
[[nodiscard]] Error not_a_file(const std::string& path, mode_t mode);

/// The most symbolic links that Linux follows in a row.
inline constexpr int most_links = 40;

/// Returns the path at which a chain of symbolic links ends, or `path` if it is not a link.
[[nodiscard]] std::string end_of_links(const std::string& path);

} // namespace raymarch
