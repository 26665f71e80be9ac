// SPDX-License-Identifier: MIT
/// @file
/// Locks that keep two services from using the same file or device.
///
/// Taking a lock never waits. A lock ends with its process. It is advisory: it keeps out only
/// programs that ask for it. An error names the holder if the kernel tells which process it is.
#pragma once

#include "base/result.hpp"
#include "base/unique_fd.hpp"

#include <string>
#include <utility>

namespace raymarch::drivers
{

/// Locks the file behind an open descriptor until the last copy of the descriptor is closed. `name`
/// is for messages. Errors: Unavailable if another process has the lock (held_by_another() is
/// true), InputOutput if the file system has no locks.
[[nodiscard]] Result<void> lock_descriptor(int fd, const std::string& name);

/// Returns whether an error of these functions says that another process has the lock.
[[nodiscard]] bool held_by_another(const Error& error) noexcept;

/// A file that exists only to be locked. It is empty, and its holder removes it. A file that a
/// killed process left behind is not locked, so it keeps nobody out.
class LockFile
{
  public:
    /// Makes and locks the file at `path`. Errors: as lock_descriptor(); InputOutput also if the
    /// file cannot be made (its folder cannot be written, or something else has that name).
    [[nodiscard]] static Result<LockFile> take(const std::string& path);

    /// Takes PATH.lock as the lock of the file at `path`, which need not exist yet. Symbolic links
    /// are followed first, so that two names of one file have one lock. Anything that is not an
    /// ordinary file, such as a device, is not locked; the result then holds nothing. Errors: as
    /// take().
    [[nodiscard]] static Result<LockFile> take_for(const std::string& path);

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
