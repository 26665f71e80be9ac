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

bool write_all(int fd, std::span<const std::uint8_t> bytes) noexcept
{
    while (!bytes.empty()) {
        const ssize_t size = ::write(fd, bytes.data(), bytes.size());
        if (size < 0 && errno == EINTR)
            continue;
        if (size < 0)
            return false;
        bytes = bytes.subspan(static_cast<std::size_t>(size));
    }
    return true;
}

/// The rename is in the folder, so the folder has to reach the disk too.
bool sync_folder(const std::string& path) noexcept
{
    const std::string folder = std::filesystem::path(path).parent_path().string();
    const UniqueFd fd(
        ::open(folder.empty() ? "." : folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
    return fd && ::fsync(fd.get()) == 0;
}

Result<void> write_fresh(const std::string& path, std::span<const std::uint8_t> bytes,
                         Durability durability)
{
    const UniqueFd fd(
        ::open(path.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_NOFOLLOW | O_CLOEXEC, 0644));
    if (!fd)
        return fail(errno_error(ErrorKind::InputOutput, "make", path));
    if (!write_all(fd.get(), bytes))
        return fail(errno_error(ErrorKind::InputOutput, "write", path));
    if (durability == Durability::Durable && ::fsync(fd.get()) != 0)
        return fail(errno_error(ErrorKind::InputOutput, "sync", path));
    return {};
}

} // namespace

Result<void> replace_file(const std::string& path, std::span<const std::uint8_t> bytes,
                          Durability durability)
{
    const std::string fresh = path + ".new";
    auto result = write_fresh(fresh, bytes, durability);
    if (result && std::rename(fresh.c_str(), path.c_str()) != 0)
        result = fail(errno_error(ErrorKind::InputOutput, "replace", path));
    if (!result) {
        ::unlink(fresh.c_str());
        return result;
    }
    if (durability == Durability::Durable && !sync_folder(path))
        return fail(errno_error(ErrorKind::InputOutput, "sync the folder of", path));
    return {};
}

Result<std::string> read_file(const std::string& path, std::size_t limit)
{
    const UniqueFd fd(::open(path.c_str(), O_RDONLY | O_CLOEXEC));
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

} // namespace raymarch::drivers
