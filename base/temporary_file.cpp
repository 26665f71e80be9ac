// SPDX-License-Identifier: MIT
#include "base/temporary_file.hpp"

#include <fcntl.h>
#include <sys/xattr.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <utility>

namespace raymarch
{
namespace
{

namespace fs = std::filesystem;

constexpr int max_attempts = 100;
constexpr std::size_t longest_ending = 8; ///< a longer ending does not name a format
constexpr const char* access_list = "system.posix_acl_access";

/// The temporary name is always short, because the final name may already have the longest length.
std::string temporary_name(const fs::path& path)
{
    const std::string ending = path.extension().string();
    const auto now = std::chrono::system_clock::now().time_since_epoch().count();
    return (path.parent_path() / (".raymarch-" + std::to_string(::getpid()) + "-" +
                                  std::to_string(static_cast<unsigned long long>(now)) +
                                  (ending.size() <= longest_ending ? ending : "")))
        .string();
}

/// Copies the access control list of the old file. Returns false if the new file cannot have it.
bool copy_access_list(const std::string& from, int to) noexcept
{
    std::array<char, 4096> list{};
    const ssize_t size = ::getxattr(from.c_str(), access_list, list.data(), list.size());
    if (size < 0 && errno == ERANGE)
        return false;
    if (size > 0)
        return ::fsetxattr(to, access_list, list.data(), static_cast<std::size_t>(size), 0) == 0;
    static_cast<void>(
        ::fremovexattr(to, access_list)); // removes the list that the folder gives to new files
    return true;
}

/// Gives the new file the owner, the group and the permissions of the old one. If a step is not
/// permitted, other users get less access than before, never more.
void copy_access(int fd, const FileTarget& target) noexcept
{
    const struct stat& old = *target.file;
    struct stat fresh = {};
    if (::fstat(fd, &fresh) != 0)
        return;
    if (fresh.st_uid != old.st_uid)
        static_cast<void>(::fchown(fd, old.st_uid, static_cast<gid_t>(-1)));
    const bool same_group =
        fresh.st_gid == old.st_gid || ::fchown(fd, static_cast<uid_t>(-1), old.st_gid) == 0;
    mode_t mode = old.st_mode & 0777U;
    // If the group cannot be kept, the new group gets only the permissions of all other users.
    if (!same_group || !copy_access_list(target.path, fd))
        mode &= ~0070U | (mode & 0007U) << 3U;
    if ((fresh.st_mode & 0777U) != mode) // a file system without modes refuses any chmod
        static_cast<void>(::fchmod(fd, mode));
}

/// Syncs the folder, because a rename changes the folder and not the file.
bool sync_folder_of(const std::string& path) noexcept
{
    const std::string folder = fs::path(path).parent_path().string();
    const UniqueFd fd(
        ::open(folder.empty() ? "." : folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
    return fd && ::fsync(fd.get()) == 0;
}

} // namespace

Result<std::string> make_temporary(const std::string& path,
                                   const std::function<bool(const std::string&)>& make)
{
    for (int attempt = 0; attempt < max_attempts; ++attempt) {
        std::string name = temporary_name(path);
        if (make(name))
            return name;
        if (errno != EEXIST)
            break;
    }
    return fail(errno_error(ErrorKind::InputOutput, "make a temporary file beside", path));
}

TemporaryFile::TemporaryFile(std::string name, FileTarget target) noexcept
    : name_(std::move(name))
    , target_(std::move(target.path))
{}

TemporaryFile::TemporaryFile(TemporaryFile&& other) noexcept
    : name_(std::move(other.name_))
    , target_(std::move(other.target_))
    , path_(std::exchange(other.path_, {}))
    , fd_(std::move(other.fd_))
{}

TemporaryFile& TemporaryFile::operator=(TemporaryFile&& other) noexcept
{
    std::swap(name_, other.name_);
    std::swap(target_, other.target_);
    std::swap(path_, other.path_);
    std::swap(fd_, other.fd_);
    return *this;
}

TemporaryFile::~TemporaryFile()
{
    if (!path_.empty())
        ::unlink(path_.c_str());
}

Result<TemporaryFile> TemporaryFile::open(const std::string& final_path, const std::string& folder)
{
    const auto target = find_target(final_path);
    if (!target)
        return fail(target.error());
    // A rename does not check whether the old file may be written, so this is checked here.
    if (target->file && ::faccessat(AT_FDCWD, target->path.c_str(), W_OK, AT_EACCESS) != 0 &&
        errno != ENOENT)
        return fail(errno_error(ErrorKind::InputOutput, "replace", final_path));
    TemporaryFile file(final_path, *target);
    const bool beside = folder.empty() || target->path != final_path;
    const std::string place =
        beside ? target->path : (fs::path(folder) / fs::path(final_path).filename()).string();
    // Nobody else can open the new file before it has the permissions of the old one.
    const mode_t mode = target->file ? 0600 : 0666;
    auto made = make_temporary(place, [&](const std::string& name) {
        file.fd_ = UniqueFd(
            ::open(name.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, mode));
        return static_cast<bool>(file.fd_);
    });
    if (!made)
        return fail(made.error());
    file.path_ = *std::move(made);
    if (target->file)
        copy_access(file.fd_.get(), *target);
    return file;
}

Result<void> TemporaryFile::write(std::span<const std::uint8_t> bytes)
{
    while (!bytes.empty()) {
        const ssize_t size = ::write(fd_.get(), bytes.data(), bytes.size());
        if (size < 0 && errno == EINTR)
            continue;
        if (size < 0)
            return fail(errno_error(ErrorKind::InputOutput, "write", name_));
        bytes = bytes.subspan(static_cast<std::size_t>(size));
    }
    return {};
}

Result<void> TemporaryFile::close()
{
    if (fd_ && ::close(fd_.release()) != 0) // a network file system may report an error only here
        return fail(errno_error(ErrorKind::InputOutput, "write", name_));
    return {};
}

Result<void> TemporaryFile::commit(Durability durability)
{
    const bool durable = durability == Durability::Durable;
    if (durable && ::fsync(fd_.get()) != 0)
        return fail(errno_error(ErrorKind::InputOutput, "sync", name_));
    if (auto closed = close(); !closed)
        return closed;
    struct stat now = {}; // another process may have changed the target meanwhile
    if (::lstat(target_.c_str(), &now) == 0 && !S_ISREG(now.st_mode))
        return fail(not_a_file(name_, now.st_mode));
    if (std::rename(path_.c_str(), target_.c_str()) != 0)
        return fail(errno_error(ErrorKind::InputOutput, "replace", name_));
    path_.clear();
    if (durable && !sync_folder_of(target_))
        return fail(errno_error(ErrorKind::InputOutput, "sync the folder of", name_));
    return {};
}

} // namespace raymarch
