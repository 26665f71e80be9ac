// SPDX-License-Identifier: MIT
#include "service/far_end.hpp"

#include "drivers/serial_port.hpp"
#include "protocol/checksum.hpp"

#include <fcntl.h>
#include <poll.h>
#include <stdlib.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#include <algorithm>
#include <array>

namespace raymarch::tests
{
namespace
{

UniqueFd listen_at(const std::string& path)
{
    UniqueFd fd(::socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0));
    sockaddr_un address = {};
    address.sun_family = AF_UNIX;
    std::copy_n(path.c_str(), std::min(path.size(), sizeof address.sun_path - 1), address.sun_path);
    if (::bind(fd.get(), reinterpret_cast<const sockaddr*>(&address), sizeof address) != 0 ||
        ::listen(fd.get(), 1) != 0)
        return {};
    return fd;
}

} // namespace

FarEnd::FarEnd(const TemporaryFolder& folder, Place place, Behaviour behaviour)
{
    static unsigned number = 0;
    if (place == Place::Socket) {
        const std::string path = folder / ("far" + std::to_string(number++));
        listener_ = listen_at(path);
        options_ = {"--socket", path};
        thread_ = std::thread([fd = listener_.get(), behaviour = std::move(behaviour)] {
            const UniqueFd client(::accept4(fd, nullptr, nullptr, SOCK_CLOEXEC));
            if (client)
                behaviour(client.get());
        });
        return;
    }
    listener_ = UniqueFd(::posix_openpt(O_RDWR | O_NOCTTY | O_CLOEXEC));
    std::array<char, 64> name{};
    if (::grantpt(listener_.get()) != 0 || ::unlockpt(listener_.get()) != 0 ||
        ::ptsname_r(listener_.get(), name.data(), name.size()) != 0)
        return;
    held_ = UniqueFd(::open(name.data(), O_RDWR | O_NOCTTY | O_CLOEXEC));
    termios settings = {};
    ::tcgetattr(held_.get(), &settings);
    drivers::make_raw(settings);
    ::tcsetattr(held_.get(), TCSANOW, &settings);
    options_ = {"--port", name.data()};
    thread_ =
        std::thread([fd = listener_.get(), behaviour = std::move(behaviour)] { behaviour(fd); });
}

FarEnd::~FarEnd()
{
    held_.reset(); // the last one at that end: a read of the terminal says so
    ::shutdown(listener_.get(), SHUT_RDWR);
    if (thread_.joinable())
        thread_.join();
}

bool write_all(int fd, std::string_view bytes)
{
    while (!bytes.empty()) {
        const ssize_t size = ::write(fd, bytes.data(), bytes.size());
        if (size <= 0)
            return false;
        bytes.remove_prefix(static_cast<std::size_t>(size));
    }
    return true;
}

std::string read_bytes(int fd)
{
    std::array<char, 65'536> chunk{};
    const ssize_t size = ::read(fd, chunk.data(), chunk.size());
    return {chunk.data(), static_cast<std::size_t>(std::max<ssize_t>(size, 0))};
}

FarEnd::Behaviour answers(std::function<std::string(const std::string& line)> answer)
{
    return [answer = std::move(answer)](int fd) {
        std::string pending;
        for (std::string bytes = read_bytes(fd); !bytes.empty(); bytes = read_bytes(fd)) {
            pending += bytes;
            for (std::size_t end = pending.find('\n'); end != std::string::npos;
                 end = pending.find('\n')) {
                if (end > 0 && !write_all(fd, answer(pending.substr(0, end))))
                    return;
                pending.erase(0, end + 1);
            }
        }
    };
}

FarEnd::Behaviour relays(std::string control_socket, Left left)
{
    return [control_socket = std::move(control_socket), left = std::move(left)](int fd) {
        const Host service = Host::on_socket(control_socket);
        service.send(left.sent);
        std::string bytes = read_bytes(fd); // the tool is there
        write_all(fd, left.coming);
        while (!bytes.empty()) {
            service.send(bytes);
            if (left.echoes)
                write_all(fd, bytes);
            std::array<pollfd, 2> waiting = {
                pollfd{.fd = fd, .events = POLLIN, .revents = 0},
                pollfd{.fd = service.fd(), .events = POLLIN, .revents = 0},
            };
            while (::poll(waiting.data(), waiting.size(), -1) > 0 && waiting[0].revents == 0)
                if (!write_all(fd, read_bytes(service.fd())))
                    return;
            bytes = read_bytes(fd);
        }
    };
}

std::string marked(std::string_view line)
{
    const auto sum = protocol::xor_of(line);
    return std::string(line) + '*' + protocol::hex_digits[sum >> 4] +
           protocol::hex_digits[sum & 0xF] + "\r\n";
}

} // namespace raymarch::tests
