// SPDX-License-Identifier: MIT
/// @file
/// A file descriptor with one owner, which closes it once.
#pragma once

#include <unistd.h>

#include <utility>

namespace raymarch
{

/// Owns a descriptor; -1 means none. close() is never retried, because on Linux the descriptor is
/// closed even if close() reports EINTR.
class UniqueFd
{
  public:
    UniqueFd() noexcept = default;
    explicit UniqueFd(int fd) noexcept : fd_(fd) {}
    UniqueFd(UniqueFd&& other) noexcept : fd_(std::exchange(other.fd_, -1)) {}
    UniqueFd& operator=(UniqueFd&& other) noexcept
    {
        if (this != &other) {
            reset();
            fd_ = std::exchange(other.fd_, -1);
        }
        return *this;
    }
    UniqueFd(const UniqueFd&) = delete;
    UniqueFd& operator=(const UniqueFd&) = delete;
    ~UniqueFd() { reset(); }

    void reset() noexcept
    {
        if (fd_ >= 0)
            ::close(fd_);
        fd_ = -1;
    }

    [[nodiscard]] int get() const noexcept { return fd_; }
    /// Gives up ownership: the caller has to close the descriptor.
    [[nodiscard]] int release() noexcept { return std::exchange(fd_, -1); }
    [[nodiscard]] explicit operator bool() const noexcept { return fd_ >= 0; }

  private:
    int fd_ = -1;
};

} // namespace raymarch
