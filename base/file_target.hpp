// SPDX-License-Identifier: MIT
/// @file
/// What stands at a path that is about to be read or written: everybody who opens a file looks
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
    std::string path;                  ///< behind all symbolic links
    std::optional<struct ::stat> file; ///< the ordinary file there; nothing where there is none
};

/// Follows symbolic links; one that leads to nothing leads to where its file would be. Whether a
/// link may be followed is left to the kernel, which is strict in folders such as /tmp.
/// Errors: InputOutput for whatever is there and no ordinary file, a loop of links, an open file
/// without a name.
[[nodiscard]] Result<FileTarget> find_target(const std::string& path);

/// The error for a path at which something else than an ordinary file is:
/// "PATH is a FIFO, not a file".
[[nodiscard]] Error not_a_file(const std::string& path, mode_t mode);

/// As many symbolic links in a row as Linux follows.
inline constexpr int most_links = 40;

/// The path that a chain of symbolic links ends at; `path` itself where it is no link.
[[nodiscard]] std::string end_of_links(const std::string& path);

} // namespace raymarch
