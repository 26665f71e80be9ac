// SPDX-License-Identifier: MIT
/// @file
/// Unix-domain stream sockets: the listening socket of the service, and connections.
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

/// The longest path that a socket address can hold.
inline constexpr std::size_t max_socket_path = sizeof(sockaddr_un::sun_path) - 1;

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

/// A listening socket with mode 0660. The lock PATH.lock tells that a process listens.
class SocketListener
{
  public:
    /// Replaces a socket that nobody listens to. Errors: Usage (the path is too long), Unavailable
    /// (another process listens on it, or something else has that name), InputOutput.
    [[nodiscard]] static Result<SocketListener> open(const std::string& path);
    SocketListener(SocketListener&&) noexcept = default;
    SocketListener& operator=(SocketListener&&) = delete; // opened once, closed once
    SocketListener(const SocketListener&) = delete;
    SocketListener& operator=(const SocketListener&) = delete;
    /// Removes the socket unless another one has replaced it.
    ~SocketListener();

    [[nodiscard]] int fd() const noexcept { return fd_.get(); }
    /// Returns the next waiting client, or nullptr if there is none. Errors: Unavailable, if a
    /// client waits and cannot be accepted (no descriptor is left).
    [[nodiscard]] Result<std::unique_ptr<SocketPort>> accept();
    /// Returns false if the socket was removed or replaced, so that no client can find it.
    [[nodiscard]] bool in_place() const noexcept;

  private:
    SocketListener(UniqueFd fd, std::string path, FileIdentity own,
                   std::optional<LockFile> lock) noexcept
        : lock_(std::move(lock))
        , fd_(std::move(fd))
        , path_(std::move(path))
        , own_(own)
    {}
    std::optional<LockFile> lock_; ///< declared first: the socket is removed before its lock
    UniqueFd fd_;
    std::string path_;
    FileIdentity own_; ///< identifies the file in the file system, not the descriptor
};

} // namespace raymarch::drivers
