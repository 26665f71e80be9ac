// SPDX-License-Identifier: MIT
/// @file
/// One owner of each thing: locks that two services take on what both would use.
///
/// A lock never waits, and ends with its process, however that ends. It binds only programs that
/// ask for it. Who has it is told where the kernel tells.
#pragma once

#include "base/result.hpp"
#include "base/unique_fd.hpp"

#include <string>

namespace raymarch::drivers
{

/// Locks the file behind an open descriptor, until the last copy of the descriptor is closed;
/// `name` is for messages. Errors: Unavailable, for which held_by_another() is true, when somebody
/// has the lock; InputOutput where the file system has no locks.
[[nodiscard]] Result<void> lock_descriptor(int fd, const std::string& name);

/// Whether an error of this file says that another holder has the lock, and not that there can be
/// none.
[[nodiscard]] bool held_by_another(const Error& error) noexcept;

/// A file that is there for its lock alone. It is empty, and removed by its last holder; one that a
/// killed process left behind locks nobody out.
class LockFile
{
  public:
    /// Makes and locks the file at `path`. Errors: as lock_descriptor(); InputOutput also when it
    /// cannot be made (a place that cannot be written, something else of that name).
    [[nodiscard]] static Result<LockFile> take(const std::string& path);

    /// Locks the ordinary file that `path` names, or will name: takes PATH.lock, behind symbolic
    /// links, so that two names of one file have one lock. What is there and is no ordinary file
    /// (a device) has no owner: the lock that is returned holds nothing.
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
