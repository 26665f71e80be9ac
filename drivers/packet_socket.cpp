// SPDX-License-Identifier: MIT
#include "drivers/packet_socket.hpp"

#include <arpa/inet.h>
#include <linux/if_ether.h>
#include <linux/if_packet.h>
#include <net/if.h>
#include <net/if_arp.h>
#include <poll.h>
#include <sys/ioctl.h>
#include <sys/socket.h>

#include <algorithm>
#include <cerrno>
#include <cstring>

namespace raymarch::drivers
{
namespace
{

using Clock = std::chrono::steady_clock;

/// The buffer holds a burst of a few hundred small frames; the system's default does not.
constexpr int receive_buffer_bytes = 4 << 20;

std::string interface_names()
{
    std::string names;
    struct if_nameindex* const list = ::if_nameindex();
    if (list == nullptr)
        return "none";
    for (const struct if_nameindex* row = list; row->if_name != nullptr; ++row)
        names.append(names.empty() ? "" : ", ").append(row->if_name);
    ::if_freenameindex(list);
    return names;
}

Error unavailable(const std::string& interface, const std::string& why)
{
    return plain_error(ErrorKind::Unavailable, interface + ": " + why);
}

/// The protocol is 0, because the socket would receive the frames of all interfaces before the
/// bind.
Result<UniqueFd> make_socket(const std::string& interface)
{
    UniqueFd fd(::socket(AF_PACKET, SOCK_RAW | SOCK_CLOEXEC | SOCK_NONBLOCK, 0));
    if (fd)
        return fd;
    if (errno == EPERM || errno == EACCES)
        return fail(unavailable(interface, "raw Ethernet frames are not permitted: the program "
                                           "needs the capability CAP_NET_RAW, which root has"));
    return fail(errno_error(ErrorKind::Unavailable, "make", "a packet socket for " + interface));
}

/// bind() succeeds on an interface that is down, so this is checked first.
bool is_up(int fd, const std::string& interface) noexcept
{
    ifreq request = {};
    interface.copy(request.ifr_name, sizeof request.ifr_name - 1);
    return ::ioctl(fd, SIOCGIFFLAGS, &request) == 0 && (request.ifr_flags & IFF_UP) != 0;
}

/// Exceeds the limit of an ordinary user if that is permitted.
void enlarge_receive_buffer(int fd) noexcept
{
    constexpr int size = receive_buffer_bytes;
    if (::setsockopt(fd, SOL_SOCKET, SO_RCVBUFFORCE, &size, sizeof size) != 0)
        ::setsockopt(fd, SOL_SOCKET, SO_RCVBUF, &size, sizeof size);
}

Result<void> bind_to(int fd, const std::string& interface, unsigned index)
{
    sockaddr_ll address = {};
    address.sll_family = AF_PACKET;
    address.sll_protocol = htons(ETH_P_ALL);
    address.sll_ifindex = static_cast<int>(index);
    socklen_t size = sizeof address;
    auto* const generic = reinterpret_cast<sockaddr*>(&address);
    packet_mreq membership = {};
    membership.mr_ifindex = address.sll_ifindex;
    membership.mr_type = PACKET_MR_PROMISC;
    if (::bind(fd, generic, size) != 0 || ::getsockname(fd, generic, &size) != 0 ||
        ::setsockopt(fd, SOL_PACKET, PACKET_ADD_MEMBERSHIP, &membership, sizeof membership) != 0)
        return fail(errno_error(ErrorKind::Unavailable, "receive frames of", interface));
    if (address.sll_hatype != ARPHRD_ETHER && address.sll_hatype != ARPHRD_LOOPBACK)
        return fail(unavailable(interface, "it is not an Ethernet interface"));
    return {};
}

bool wait_for(int fd, short events, std::chrono::milliseconds timeout) noexcept
{
    pollfd waiting = {.fd = fd, .events = events, .revents = 0};
    return ::poll(&waiting, 1, static_cast<int>(timeout.count())) > 0;
}

} // namespace

Result<std::unique_ptr<PacketSocket>> PacketSocket::open(const std::string& interface)
{
    const unsigned index = ::if_nametoindex(interface.c_str());
    if (index == 0)
        return fail(unavailable(interface, "there is no such interface; the interfaces are " +
                                               interface_names()));
    auto fd = make_socket(interface);
    if (!fd)
        return fail(fd.error());
    if (!is_up(fd->get(), interface))
        return fail(unavailable(interface, "the interface is down"));
    enlarge_receive_buffer(fd->get());
    if (auto bound = bind_to(fd->get(), interface, index); !bound)
        return fail(bound.error());
    return std::unique_ptr<PacketSocket>(new PacketSocket(std::move(*fd), interface));
}

Result<void> PacketSocket::send(std::span<const std::uint8_t> frame)
{
    const auto deadline = Clock::now() + std::chrono::seconds(1);
    while (::send(fd_.get(), frame.data(), frame.size(), 0) < 0) {
        const bool full = errno == EAGAIN || errno == ENOBUFS; // socket or interface queue
        if (errno != EINTR && !(full && Clock::now() < deadline))
            return fail(errno_error(ErrorKind::InputOutput, "send a frame on", interface_));
        if (full) // poll() does not see the interface queue, so this only waits
            wait_for(fd_.get(), errno == EAGAIN ? POLLOUT : short{0}, std::chrono::milliseconds(1));
    }
    return {};
}

Result<std::optional<std::size_t>> PacketSocket::receive(std::span<std::uint8_t> into,
                                                         std::chrono::milliseconds timeout)
{
    const auto deadline = Clock::now() + timeout;
    for (;;) {
        sockaddr_ll from = {};
        socklen_t from_size = sizeof from;
        const ssize_t size = ::recvfrom(fd_.get(), into.data(), into.size(), 0,
                                        reinterpret_cast<sockaddr*>(&from), &from_size);
        if (size >= 0 && from.sll_pkttype != PACKET_OUTGOING) // the frame is incoming
            return static_cast<std::size_t>(size);
        if (size >= 0 || errno == EINTR)
            continue;
        if (errno != EAGAIN)
            return fail(errno_error(ErrorKind::InputOutput, "receive frames of", interface_));
        const auto left = std::chrono::ceil<std::chrono::milliseconds>(deadline - Clock::now());
        if (left.count() <= 0)
            return std::nullopt;
        wait_for(fd_.get(), POLLIN, left);
    }
}

} // namespace raymarch::drivers
