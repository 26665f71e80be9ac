// SPDX-License-Identifier: MIT
#include "drivers/lock_file.hpp"

#include "drivers/file_identity.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <filesystem>
#include <fstream>
#include <system_error>

namespace raymarch::drivers
{
namespace
{

namespace fs = std::filesystem;

/// flock() does not tell who holds a lock, and locks of fcntl() that do are lost too easily: with
/// any descriptor of the file that the process closes. So flock() keeps others out, and a lock of
/// fcntl() beside it serves only as the holder's name tag.
struct flock name_tag(short type) noexcept
{
    struct flock tag = {};
    tag.l_type = type;
    tag.l_whence = SEEK_SET;
    tag.l_len = 1;
    return tag;
}

void hang_out_name_tag(int fd) noexcept
{
    struct flock tag = name_tag(F_RDLCK); // for reading: the descriptor may be open for no more
    static_cast<void>(::fcntl(fd, F_SETLK, &tag));
}

/// "process 12 (raymarchd)"; without the name where /proc hides it, "another process" where the
/// kernel does not tell at all, as of a process in another container.
std::string holder_of(int fd)
{
    struct flock tag = name_tag(F_WRLCK);
    if (::fcntl(fd, F_GETLK, &tag) != 0 || tag.l_type == F_UNLCK || tag.l_pid <= 0)
        return "another process";
    const std::string number = std::to_string(tag.l_pid);
    std::string name;
    std::ifstream("/proc/" + number + "/comm") >> name;
    return "process " + number + (name.empty() ? "" : " (" + name + ")");
}

/// Where a file of that name is, or will be: also behind a link whose target is not there yet.
fs::path real_place(fs::path path)
{
    constexpr int most_links = 40; // as the kernel
    std::error_code error;
    for (int i = 0; i < most_links && fs::is_symlink(fs::symlink_status(path, error)); ++i)
        path = path.parent_path() / fs::read_symlink(path, error);
    fs::path real = fs::weakly_canonical(path, error);
    return error ? path : real;
}

Result<UniqueFd> open_lock_file(const std::string& path)
{
    // Reading is enough for the lock, also where the file belongs to another user.
    UniqueFd fd(
        ::open(path.c_str(), O_RDONLY | O_CREAT | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC, 0644));
    if (!fd)
        return fail(errno_error(ErrorKind::InputOutput, "make", path));
    struct stat info = {};
    if (::fstat(fd.get(), &info) != 0)
        return fail(errno_error(ErrorKind::InputOutput, "stat", path));
    if (!S_ISREG(info.st_mode))
        return fail(plain_error(ErrorKind::InputOutput, path + " is there and is no lock file"));
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
        hang_out_name_tag(fd);
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
        // The last holder may have removed it between our open and our lock: then it is nobody's.
        if (identity_of(fd->get()) == identity_of_link(path))
            return LockFile(std::move(*fd), path);
    }
}

Result<LockFile> LockFile::beside(const std::string& path)
{
    const std::string file = real_place(path).string();
    std::error_code error;
    const fs::file_status there = fs::status(file, error);
    if (fs::exists(there) && !fs::is_regular_file(there))
        return LockFile();
    auto lock = take(file + ".lock");
    if (!lock && held_by_another(lock.error())) // the message is to name what the user named
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

/// Removed while it is still locked: who has the old file open by now sees that it has no name. One
/// that holds something is the user's and stays.
void LockFile::release() noexcept
{
    struct stat info = {};
    const bool empty = fd_ && ::fstat(fd_.get(), &info) == 0 && info.st_size == 0;
    if (empty && identity_of(fd_.get()) == identity_of_link(path_))
        ::unlink(path_.c_str());
    fd_.reset();
}

} // namespace raymarch::drivers
