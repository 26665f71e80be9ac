// SPDX-License-Identifier: MIT
/// @file
/// Which file it is, whatever its name: to tell one's own from what others have put in its place.
#pragma once

#include <sys/stat.h>

#include <optional>
#include <string>

namespace raymarch::drivers
{

struct FileIdentity
{
    dev_t device = 0;
    ino_t number = 0;
    bool operator==(const FileIdentity&) const = default;
};

/// The file behind a descriptor; nothing when there is none.
[[nodiscard]] inline std::optional<FileIdentity> identity_of(int fd) noexcept
{
    struct stat info = {};
    if (::fstat(fd, &info) != 0)
        return std::nullopt;
    return FileIdentity{info.st_dev, info.st_ino};
}

/// The file that has a name now, where a symbolic link counts as itself; nothing when there is
/// none.
[[nodiscard]] inline std::optional<FileIdentity> identity_of_link(const std::string& path) noexcept
{
    struct stat info = {};
    if (::lstat(path.c_str(), &info) != 0)
        return std::nullopt;
    return FileIdentity{info.st_dev, info.st_ino};
}

} // namespace raymarch::drivers
