// SPDX-License-Identifier: MIT
#include "console/connection.hpp"

#include "drivers/serial_port.hpp"
#include "drivers/unix_socket.hpp"

#include <fmt/format.h>
#include <poll.h>

#include <array>
#include <charconv>

namespace raymarch::console
{
namespace
{

constexpr unsigned default_baud = 115'200;

Result<std::unique_ptr<drivers::BytePort>> open_port(const std::string& text)
{
    const std::size_t at = text.rfind('@');
    unsigned baud = default_baud;
    if (at != std::string::npos) {
        const char* const end = text.data() + text.size();
        const auto parsed = std::from_chars(text.data() + at + 1, end, baud);
        if (parsed.ec != std::errc{} || parsed.ptr != end)
            return fail(plain_error(ErrorKind::Usage, "'" + text + "' is not TTY[@BAUD]"));
    }
    return drivers::SerialPort::open(text.substr(0, at), baud);
}

Result<std::unique_ptr<drivers::BytePort>> open_endpoint(const Endpoint& endpoint)
{
    if (!endpoint.port.empty())
        return open_port(endpoint.port);
    return drivers::SocketPort::connect(endpoint.socket.empty() ? default_socket : endpoint.socket);
}

} // namespace

void add_endpoint_options(CLI::App& command, Endpoint& endpoint)
{
    CLI::Option* const port = command
                                  .add_option("--port", endpoint.port,
                                              "the service's serial port, or its "
                                              "pseudo-terminal; default baud 115200")
                                  ->type_name("TTY[@BAUD]");
    command
        .add_option("--socket", endpoint.socket,
                    std::string("the service's control socket (default: ") + default_socket + ")")
        ->type_name("PATH")
        ->excludes(port);
}

Result<Connection> Connection::open(const Endpoint& endpoint)
{
    auto port = open_endpoint(endpoint);
    if (!port)
        return fail(port.error());
    return Connection(std::move(*port));
}

bool Connection::wait(short events, std::chrono::milliseconds timeout) const
{
    pollfd descriptor = {.fd = port_->fd(), .events = events, .revents = 0};
    return ::poll(&descriptor, 1, static_cast<int>(timeout.count())) > 0;
}

Result<void> Connection::send(std::string_view bytes)
{
    while (!bytes.empty()) {
        const std::size_t taken = port_->write(bytes);
        bytes.remove_prefix(taken);
        if (taken == 0 && !wait(POLLOUT, reply_timeout))
            return fail(plain_error(ErrorKind::InputOutput, "the service takes no bytes"));
        if (taken == 0) { // room, or an end: only a read tells which
            std::array<char, 4096> chunk{};
            const auto outcome = port_->read(chunk);
            received_.append(chunk.data(), outcome.size);
            if (outcome.status == drivers::ReadStatus::Gone)
                return fail(
                    plain_error(ErrorKind::InputOutput, "the service closed the connection"));
        }
    }
    return {};
}

Result<std::string> Connection::receive(std::chrono::milliseconds timeout)
{
    const auto deadline = std::chrono::steady_clock::now() + timeout;
    for (;;) {
        if (const std::size_t end = received_.find('\n'); end != std::string::npos) {
            std::string line = received_.substr(0, end);
            received_.erase(0, end + 1);
            if (line.ends_with('\r'))
                line.pop_back();
            return line;
        }
        const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(
            deadline - std::chrono::steady_clock::now());
        if (left.count() <= 0 || !wait(POLLIN, left))
            return fail(plain_error(ErrorKind::InputOutput, "no reply came in time"));
        std::array<char, 4096> chunk{};
        const auto outcome = port_->read(chunk);
        received_.append(chunk.data(), outcome.size);
        if (outcome.status == drivers::ReadStatus::Gone)
            return fail(plain_error(ErrorKind::InputOutput, "the service closed the connection"));
    }
}

Result<std::vector<std::string>> Connection::ask(std::string_view line)
{
    if (auto sent = send(std::string(line) + "\n"); !sent)
        return fail(sent.error());
    std::vector<std::string> replies;
    for (;;) {
        auto reply = receive();
        if (!reply)
            return fail(reply.error());
        const bool last = reply->starts_with("OK") || is_err(*reply);
        if (last || reply->starts_with('#')) // anything else is an echo of what was sent
            replies.push_back(std::move(*reply));
        if (last)
            return replies;
    }
}

void Connection::drain(std::chrono::milliseconds quiet)
{
    while (receive(quiet)) {
    }
    received_.clear();
}

Result<std::string> ask_and_print(Connection& connection, std::string_view line)
{
    const auto replies = connection.ask(line);
    if (!replies)
        return fail(replies.error());
    for (const std::string& reply : *replies)
        fmt::print("{}\n", reply);
    return replies->back();
}

} // namespace raymarch::console
