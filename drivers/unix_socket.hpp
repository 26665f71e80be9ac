// SPDX-License-Identifier: MIT
/// @file
/// A local stream socket: the service's listening end, its clients, and the tool's end.
#pragma once

#include "base/result.hpp"
#include "base/unique_fd.hpp"
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
    /// Connects to a listening socket. Errors: Unavailable.
    [[nodiscard]] static Result<std::unique_ptr<SocketPort>> connect(const std::string& path);

    [[nodiscard]] int fd() const noexcept override { return fd_.get(); }
    [[nodiscard]] ReadOutcome read(std::span<char> into) noexcept override;
    [[nodiscard]] std::size_t write(std::string_view bytes) noexcept override;

  private:
    UniqueFd fd_;
};

/// A listening socket in the file system, mode 0660.
class SocketListener
{
  public:
    /// Replaces a socket that nobody listens to any more. Errors: Unavailable (another process
    /// listens there, or something else has that name), InputOutput.
    [[nodiscard]] static Result<SocketListener> open(const std::string& path);
    SocketListener(SocketListener&&) noexcept = default;
    SocketListener& operator=(SocketListener&&) = delete; // opened once, closed once
    SocketListener(const SocketListener&) = delete;
    SocketListener& operator=(const SocketListener&) = delete;
    ~SocketListener();

    [[nodiscard]] int fd() const noexcept { return fd_.get(); }
    /// The next waiting client; nullptr when there is none. Errors: Unavailable, when one waits
    /// that cannot be taken (no descriptor is left).
    [[nodiscard]] Result<std::unique_ptr<SocketPort>> accept();

  private:
    SocketListener(UniqueFd fd, std::string path) noexcept
        : fd_(std::move(fd))
        , path_(std::move(path))
    {}
    UniqueFd fd_;
    std::string path_;
};

} // namespace raymarch::drivers
