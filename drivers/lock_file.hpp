// SPDX-License-Identifier: MIT
/// @file
/// Locks that keep two services from using the same file or device.
///
/// Taking a lock never waits. A lock ends with its process, however that ends. It keeps out only
/// programs that ask for it. An error names the holder where the kernel tells which process it is.
#pragma once

#include "base/result.hpp"
#include "base/unique_fd.hpp"

#include <string>
#include <utility>

namespace raymarch::drivers
{

/// Locks the file behind an open descriptor, until the last copy of the descriptor is closed;
/// `name` is for messages. Errors: Unavailable, for which held_by_another() is true, when another
/// process has the lock; InputOutput where the file system has no locks.
[[nodiscard]] Result<void> lock_descriptor(int fd, const std::string& name);

/// Whether an error of these functions says that another process has the lock, and not that the
/// file cannot be locked.
[[nodiscard]] bool held_by_another(const Error& error) noexcept;

/// A file that exists only to be locked. It is empty, and its holder removes it. A file that a
/// killed process left behind is not locked, so it keeps nobody out.
class LockFile
{
  public:
    /// Makes and locks the file at `path`. Errors: as lock_descriptor(); InputOutput also when the
    /// file cannot be made (its folder cannot be written, or something else has that name).
    [[nodiscard]] static Result<LockFile> take(const std::string& path);

    /// Locks the ordinary file that `path` names or will name, by taking PATH.lock. Symbolic links
    /// are followed first, so that two names of one file have one lock. A device, or anything else
    /// that is no ordinary file, is not locked: the lock that is returned then holds nothing.
    /// Errors: as take().
    [[nodiscard]] static Result<LockFile> beside(const std::string& path);

    LockFile(LockFile&&) noexcept = default;
    LockFile& operator=(LockFile&& other) noexcept;
    LockFile(const LockFile&) = delete;
    LockFile& operator=(const LockFile&) = delete;
    ~LockFile();

  private:
    LockFile() noexcept = default;
    LockFile(UniqueFd fd, std::string path) noexcept : fd_(std::move(fd)), path_(std::move(path)) {}
    void release() noexcept;

    UniqueFd fd_;
    std::string path_;
};

} // namespace raymarch::drivers
