// SPDX-License-Identifier: MIT
#include "drivers/lock_file.hpp"

#include "base/file_target.hpp"
#include "drivers/file_identity.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <filesystem>
#include <fstream>
#include <string_view>
#include <system_error>

namespace raymarch::drivers
{
namespace
{

namespace fs = std::filesystem;

/// A lock of flock() does not tell which process holds it. A lock of fcntl() does, but the kernel
/// drops it when the process closes any descriptor of the file. So flock() locks the file, and an
/// additional lock of fcntl() only tells other processes who holds it.
struct flock holder_lock(short type) noexcept
{
    struct flock lock = {};
    lock.l_type = type;
    lock.l_whence = SEEK_SET;
    lock.l_len = 1;
    return lock;
}

void publish_holder(int fd) noexcept
{
    struct flock lock = holder_lock(F_RDLCK); // the descriptor may be open for reading only
    static_cast<void>(::fcntl(fd, F_SETLK, &lock));
}

/// Returns "process 12 (raymarchd)". The name is missing if /proc hides it. The result is "another
/// process" if the kernel gives no number, as for a process in another container.
std::string holder_of(int fd)
{
    struct flock lock = holder_lock(F_WRLCK);
    if (::fcntl(fd, F_GETLK, &lock) != 0 || lock.l_type == F_UNLCK || lock.l_pid <= 0)
        return "another process";
    const std::string number = std::to_string(lock.l_pid);
    std::string name;
    std::ifstream("/proc/" + number + "/comm") >> name;
    return "process " + number + (name.empty() ? "" : " (" + name + ")");
}

/// Returns the path of the file that `path` leads to. weakly_canonical() alone does not follow a
/// link to a file that does not exist yet.
std::string real_path_of(const std::string& path)
{
    const std::string end = end_of_links(path);
    std::error_code error;
    const fs::path real = fs::weakly_canonical(end, error);
    return error ? end : real.string();
}

Result<UniqueFd> open_lock_file(const std::string& path)
{
    // Reading is enough for the lock, and is often allowed if the file belongs to another user.
    UniqueFd fd(
        ::open(path.c_str(), O_RDONLY | O_CREAT | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC, 0644));
    if (!fd)
        return fail(errno_error(ErrorKind::InputOutput, "make", path));
    struct stat info = {};
    if (::fstat(fd.get(), &info) != 0)
        return fail(errno_error(ErrorKind::InputOutput, "stat", path));
    if (!S_ISREG(info.st_mode))
        return fail(plain_error(ErrorKind::InputOutput, path + " exists and is not a lock file"));
    return fd;
}

} // namespace

bool held_by_another(const Error& error) noexcept
{
    return error.kind == ErrorKind::Unavailable && error.number == EWOULDBLOCK;
}

Result<void> lock_descriptor(int fd, const std::string& name)
{
    if (::flock(fd, LOCK_EX | LOCK_NB) == 0) {
        publish_holder(fd);
        return {};
    }
    if (errno != EWOULDBLOCK)
        return fail(errno_error(ErrorKind::InputOutput, "lock", name));
    return fail(
        Error{ErrorKind::Unavailable, EWOULDBLOCK, name + " is in use by " + holder_of(fd)});
}

Result<LockFile> LockFile::take(const std::string& path)
{
    for (;;) {
        auto fd = open_lock_file(path);
        if (!fd)
            return fail(fd.error());
        if (auto locked = lock_descriptor(fd->get(), path); !locked)
            return fail(locked.error());
        // The last holder may have removed the file before it was locked here. Another process can
        // then lock a new file of that name, so a lock of the old file is useless.
        if (identity_of(fd->get()) == identity_of_link(path))
            return LockFile(std::move(*fd), path);
    }
}

Result<LockFile> LockFile::take_for(const std::string& path)
{
    const std::string file = real_path_of(path);
    std::error_code error;
    const fs::file_status there = fs::status(file, error);
    if (fs::exists(there) && !fs::is_regular_file(there))
        return LockFile();
    auto lock = take(file + ".lock");
    if (!lock && held_by_another(lock.error())) // the message names the path as given
        lock.error().message.replace(0, file.size() + std::string_view(".lock").size(), path);
    return lock;
}

LockFile& LockFile::operator=(LockFile&& other) noexcept
{
    if (this != &other) {
        release();
        fd_ = std::move(other.fd_);
        path_ = std::move(other.path_);
    }
    return *this;
}

LockFile::~LockFile()
{
    release();
}

/// Removes the file while it is locked, so that a process that has opened it meanwhile sees that
/// the name is gone. A file that is not empty belongs to the user and stays.
void LockFile::release() noexcept
{
    struct stat info = {};
    const bool empty = fd_ && ::fstat(fd_.get(), &info) == 0 && info.st_size == 0;
    if (empty && identity_of(fd_.get()) == identity_of_link(path_))
        ::unlink(path_.c_str());
    fd_.reset();
}

} // namespace raymarch::drivers
