// SPDX-License-Identifier: MIT
/// @file
/// A local stream socket: the service's listening end, its clients, and the tool's end.
#pragma once

#include "base/result.hpp"
#include "base/unique_fd.hpp"
#include "drivers/file_identity.hpp"
#include "drivers/lock_file.hpp"
#include "drivers/ports.hpp"

#include <sys/un.h>

#include <memory>
#include <optional>
#include <string>

namespace raymarch::drivers
{

/// The longest path that a socket's address holds.
inline constexpr std::size_t max_socket_path = sizeof(sockaddr_un::sun_path) - 1;

/// One connection.
class SocketPort final : public BytePort
{
  public:
    explicit SocketPort(UniqueFd fd) noexcept : fd_(std::move(fd)) {}
    /// Connects to a listening socket. Errors: Usage (the path is too long), Unavailable.
    [[nodiscard]] static Result<std::unique_ptr<SocketPort>> connect(const std::string& path);

    [[nodiscard]] int fd() const noexcept override { return fd_.get(); }
    [[nodiscard]] ReadOutcome read(std::span<char> into) noexcept override;
    [[nodiscard]] std::size_t write(std::string_view bytes) noexcept override;

  private:
    UniqueFd fd_;
};

/// A listening socket in the file system, mode 0660. PATH.lock beside it says that somebody
/// listens.
class SocketListener
{
  public:
    /// Replaces a socket that nobody listens to any more. Errors: Usage (the path is too long),
    /// Unavailable (another process listens there, or something else has that name), InputOutput.
    [[nodiscard]] static Result<SocketListener> open(const std::string& path);
    SocketListener(SocketListener&&) noexcept = default;
    SocketListener& operator=(SocketListener&&) = delete; // opened once, closed once
    SocketListener(const SocketListener&) = delete;
    SocketListener& operator=(const SocketListener&) = delete;
    /// Removes the socket if it is still its own.
    ~SocketListener();

    [[nodiscard]] int fd() const noexcept { return fd_.get(); }
    /// The next waiting client; nullptr when there is none. Errors: Unavailable, when one waits
    /// that cannot be taken (no descriptor is left).
    [[nodiscard]] Result<std::unique_ptr<SocketPort>> accept();
    /// False when the socket was removed, or something else has its name now: then no client finds
    /// it any more.
    [[nodiscard]] bool in_place() const noexcept;

  private:
    SocketListener(UniqueFd fd, std::string path, FileIdentity own,
                   std::optional<LockFile> lock) noexcept
        : lock_(std::move(lock))
        , fd_(std::move(fd))
        , path_(std::move(path))
        , own_(own)
    {}
    std::optional<LockFile> lock_; ///< first: the socket goes before its lock
    UniqueFd fd_;
    std::string path_;
    FileIdentity own_; ///< of the name in the file system, not of the descriptor
};

} // namespace raymarch::drivers
