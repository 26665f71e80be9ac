// SPDX-License-Identifier: MIT
#include "drivers/atomic_file.hpp"

#include "base/unique_fd.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdio>
#include <filesystem>

namespace raymarch::drivers
{
namespace
{

constexpr int most_set_aside = 100;
constexpr std::size_t longest_name = 255;

/// `number` counts from 1. A name that would be too long is cut.
std::string set_aside_name(const std::filesystem::path& path, int number)
{
    const std::string ending = number == 1 ? ".bad" : ".bad-" + std::to_string(number);
    const std::string name = path.filename().string();
    return (path.parent_path() / (name.substr(0, longest_name - ending.size()) + ending)).string();
}

/// Renames `from`. Fails with EEXIST if `to` exists.
bool rename_if_free(const char* from, const char* to) noexcept
{
    if (::renameat2(AT_FDCWD, from, AT_FDCWD, to, RENAME_NOREPLACE) == 0)
        return true;
    if (errno != EINVAL && errno != ENOSYS) // some file systems, such as NFS, cannot do it
        return false;
    return ::link(from, to) == 0 && ::unlink(from) == 0;
}

} // namespace

Result<void> replace_file(const std::string& path, std::span<const std::uint8_t> bytes,
                          Durability durability)
{
    auto file = TemporaryFile::open(path);
    if (!file)
        return fail(file.error());
    if (auto written = file->write(bytes); !written)
        return written;
    return file->commit(durability);
}

Result<std::string> read_file(const std::string& path, std::size_t limit)
{
    struct stat info = {}; // checked before open(), because opening a device may start it
    if (::stat(path.c_str(), &info) == 0 && !S_ISREG(info.st_mode))
        return fail(not_a_file(path, info.st_mode));
    const UniqueFd fd(::open(path.c_str(), O_RDONLY | O_NONBLOCK | O_NOCTTY | O_CLOEXEC));
    if (!fd)
        return fail(errno_error(ErrorKind::Unavailable, "open", path));
    std::string content;
    std::array<char, 4096> chunk{};
    for (;;) {
        const ssize_t size = ::read(fd.get(), chunk.data(), chunk.size());
        if (size < 0 && errno == EINTR)
            continue;
        if (size < 0)
            return fail(errno_error(ErrorKind::InputOutput, "read", path));
        if (size == 0)
            return content;
        content.append(chunk.data(), static_cast<std::size_t>(size));
        if (content.size() > limit)
            return fail(plain_error(ErrorKind::BadData,
                                    path + " is larger than " + std::to_string(limit) + " bytes"));
    }
}

Result<std::string> set_aside(const std::string& path)
{
    const auto target = find_target(path);
    if (!target)
        return fail(target.error());
    for (int number = 1; number <= most_set_aside; ++number) {
        const std::string name = set_aside_name(target->path, number);
        if (rename_if_free(target->path.c_str(), name.c_str()))
            return name;
        if (errno != EEXIST)
            break;
    }
    const ErrorKind kind = errno == ENOENT ? ErrorKind::Unavailable : ErrorKind::InputOutput;
    return fail(errno_error(kind, "set aside", path));
}

} // namespace raymarch::drivers
