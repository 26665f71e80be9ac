// SPDX-License-Identifier: MIT
/// @file
/// Identifies a file whatever its name is, to detect that another file has replaced it.
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

/// Returns nothing if the descriptor is not open.
[[nodiscard]] inline std::optional<FileIdentity> identity_of(int fd) noexcept
{
    struct stat info = {};
    if (::fstat(fd, &info) != 0)
        return std::nullopt;
    return FileIdentity{info.st_dev, info.st_ino};
}

/// Does not follow a symbolic link. Returns nothing if there is no such file.
[[nodiscard]] inline std::optional<FileIdentity> identity_of_link(const std::string& path) noexcept
{
    struct stat info = {};
    if (::lstat(path.c_str(), &info) != 0)
        return std::nullopt;
    return FileIdentity{info.st_dev, info.st_ino};
}

} // namespace raymarch::drivers
