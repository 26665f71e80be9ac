// SPDX-License-Identifier: MIT
#include "drivers/unix_socket.hpp"

#include "drivers/serial_port.hpp" // read_some

#include <sys/socket.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>

namespace raymarch::drivers
{
namespace
{

Result<sockaddr_un> address_of(const std::string& path)
{
    sockaddr_un address = {};
    address.sun_family = AF_UNIX;
    if (path.size() > max_socket_path)
        return fail(plain_error(ErrorKind::Usage, path + ": a socket's path has at most " +
                                                      std::to_string(max_socket_path) + " bytes"));
    std::copy(path.begin(), path.end(), address.sun_path);
    return address;
}

Result<UniqueFd> make_socket()
{
    UniqueFd fd(::socket(AF_UNIX, SOCK_STREAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0));
    if (!fd)
        return fail(errno_error(ErrorKind::Unavailable, "make", "a local socket"));
    return fd;
}

const sockaddr* generic(const sockaddr_un& address) noexcept
{
    return reinterpret_cast<const sockaddr*>(&address);
}

} // namespace

Result<std::unique_ptr<SocketPort>> SocketPort::connect(const std::string& path)
{
    auto address = address_of(path);
    if (!address)
        return fail(address.error());
    auto fd = make_socket();
    if (!fd)
        return fail(fd.error());
    if (::connect(fd->get(), generic(*address), sizeof *address) != 0)
        return fail(errno_error(ErrorKind::Unavailable, "connect to", path));
    return std::make_unique<SocketPort>(std::move(*fd));
}

ReadOutcome SocketPort::read(std::span<char> into) noexcept
{
    return read_some(fd_.get(), into, ReadStatus::Gone);
}

std::size_t SocketPort::write(std::string_view bytes) noexcept
{
    for (;;) {
        // MSG_NOSIGNAL: a client that has closed the socket must not raise SIGPIPE.
        const ssize_t size = ::send(fd_.get(), bytes.data(), bytes.size(), MSG_NOSIGNAL);
        if (size >= 0)
            return static_cast<std::size_t>(size);
        if (errno != EINTR)
            return 0;
    }
}

namespace
{

/// Removes a socket that nobody listens to, so that a new one can be made at `path`.
Result<void> make_room(const std::string& path)
{
    struct stat info = {};
    if (::lstat(path.c_str(), &info) != 0)
        return {};
    if (!S_ISSOCK(info.st_mode))
        return fail(plain_error(ErrorKind::Unavailable, path + " exists and is not a socket"));
    const auto probe = SocketPort::connect(path);
    if (probe || probe.error().number != ECONNREFUSED)
        return fail(plain_error(ErrorKind::Unavailable, path + ": another process listens on it"));
    ::unlink(path.c_str()); // a killed process left it behind
    return {};
}

} // namespace

Result<SocketListener> SocketListener::open(const std::string& path)
{
    auto address = address_of(path);
    if (!address)
        return fail(address.error());
    // The lock keeps a second service from doing the next three steps (probe, unlink, bind).
    auto lock = LockFile::take(path + ".lock");
    if (!lock && held_by_another(lock.error()))
        return fail(Error{ErrorKind::Unavailable, lock.error().number,
                          path + ": another process listens on it: " + lock.error().message});
    if (auto room = make_room(path); !room)
        return fail(room.error());

    auto fd = make_socket();
    if (!fd)
        return fail(fd.error());
    if (::bind(fd->get(), generic(*address), sizeof *address) != 0)
        return fail(errno_error(ErrorKind::Unavailable, "bind", path));
    const auto own = identity_of_link(path);
    SocketListener listener(std::move(*fd), path, own.value_or(FileIdentity{}),
                            lock ? std::optional(std::move(*lock)) : std::nullopt);
    constexpr int waiting = 16;
    if (::chmod(path.c_str(), S_IRUSR | S_IWUSR | S_IRGRP | S_IWGRP) != 0 ||
        ::listen(listener.fd(), waiting) != 0)
        return fail(errno_error(ErrorKind::InputOutput, "listen at", path));
    return listener;
}

SocketListener::~SocketListener()
{
    if (fd_ && in_place())
        ::unlink(path_.c_str());
}

bool SocketListener::in_place() const noexcept
{
    return identity_of_link(path_) == own_;
}

Result<std::unique_ptr<SocketPort>> SocketListener::accept()
{
    UniqueFd fd(::accept4(fd_.get(), nullptr, nullptr, SOCK_NONBLOCK | SOCK_CLOEXEC));
    if (fd)
        return std::make_unique<SocketPort>(std::move(fd));
    if (errno == EAGAIN || errno == ECONNABORTED || errno == EINTR)
        return nullptr;
    return fail(errno_error(ErrorKind::Unavailable, "accept a client at", path_));
}

} // namespace raymarch::drivers
