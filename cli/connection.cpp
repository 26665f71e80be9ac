// SPDX-License-Identifier: MIT
#include "cli/connection.hpp"

#include "cli/subcommands.hpp"
#include "drivers/serial_port.hpp"
#include "drivers/tty_name.hpp"
#include "drivers/unix_socket.hpp"
#include "protocol/text.hpp"

#include <fmt/format.h>
#include <poll.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <filesystem>

namespace raymarch::cli
{
namespace
{

/// Replies are far shorter. A longer line is an error, because the far end sends no line ends.
constexpr std::size_t longest_line = 1 << 20;
/// The longest wait for a reply while the far end sends other lines without a pause.
constexpr std::chrono::seconds longest_wait{30};

Result<std::unique_ptr<drivers::BytePort>> open_port(const std::string& text)
{
    std::error_code ignored;
    if (std::filesystem::exists(text, ignored)) // the file name may contain an @
        return drivers::SerialPort::open(text, drivers::default_baud);
    const auto name = drivers::parse_tty_name(text);
    if (!name)
        return fail(name.error());
    return drivers::SerialPort::open(name->path, name->baud);
}

/// Tells the user how to start a service.
Error no_service(const std::string& path)
{
    constexpr const char* start = "raymarchd --registers emulated --serial none --state none "
                                  "--control";
    const std::string how =
        path == default_socket
            ? fmt::format(
                  "start it with: systemctl start raymarchd, or start one of your own with: "
                  "{} PATH, and give --socket PATH",
                  start)
            : fmt::format("start one with: {} {}", start, path);
    return plain_error(ErrorKind::Unavailable,
                       fmt::format("no service listens on {}; {}", path, how));
}

Result<std::unique_ptr<drivers::BytePort>> open_endpoint(const Endpoint& endpoint)
{
    if (!endpoint.port.empty())
        return open_port(endpoint.port);
    const std::string path = endpoint.socket.empty() ? default_socket : endpoint.socket;
    auto port = drivers::SocketPort::connect(path);
    if (!port && (port.error().number == ENOENT || port.error().number == ECONNREFUSED))
        return fail(no_service(path));
    return port;
}

} // namespace

void add_endpoint_options(CLI::App& command, Endpoint& endpoint)
{
    CLI::Option* const port = command
                                  .add_option("--port", endpoint.port,
                                              "serial port of the service, or its pseudo-terminal; "
                                              "the rate is 115200 baud if none is given")
                                  ->type_name("TTY[@BAUD]");
    command
        .add_option("--socket", endpoint.socket,
                    std::string("control socket of the service (default: ") + default_socket + ")")
        ->type_name("PATH")
        ->excludes(port);
}

Result<Connection> Connection::open(const Endpoint& endpoint)
{
    auto port = open_endpoint(endpoint);
    if (!port)
        return fail(port.error());
    Connection connection(std::move(*port));
    auto contact = connection.synchronise();
    if (contact)
        return connection;
    if (const int number = connection.interrupted(); number != 0) {
        connection.port_.reset(); // restores the settings of the terminal
        connection.stop_.reset();
        static_cast<void>(
            std::raise(number)); // the caller gets no connection to ask for the signal
    }
    return fail(contact.error());
}

int Connection::interrupted() noexcept
{
    if (interrupted_ == 0)
        interrupted_ = stop_->take();
    return interrupted_;
}

Result<bool> Connection::wait(short events, std::chrono::milliseconds timeout)
{
    std::array<pollfd, 2> waiting = {
        pollfd{.fd = port_->fd(), .events = events, .revents = 0},
        pollfd{.fd = stop_->fd(), .events = POLLIN, .revents = 0},
    };
    const auto left = std::max(timeout, std::chrono::milliseconds{0});
    const int ready = ::poll(waiting.data(), waiting.size(), static_cast<int>(left.count()));
    if (interrupted() != 0)
        return fail(plain_error(ErrorKind::InputOutput, "interrupted"));
    return ready > 0 || (ready < 0 && errno == EINTR); // a read without data does no harm
}

Result<void> Connection::read_more()
{
    std::array<char, 4096> chunk{};
    const auto outcome = port_->read(chunk);
    received_.append(chunk.data(), outcome.size);
    if (outcome.status != drivers::ReadStatus::Gone)
        return {};
    if (received_.empty())
        return fail(plain_error(ErrorKind::InputOutput, "the service closed the connection"));
    return fail(plain_error(
        ErrorKind::InputOutput,
        fmt::format("the service closed the connection after '{}'", visible(received_))));
}

Result<void> Connection::send(std::string_view bytes)
{
    while (!bytes.empty()) {
        const std::size_t taken = port_->write(bytes);
        bytes.remove_prefix(taken);
        if (taken > 0)
            continue;
        const auto ready = wait(POLLIN | POLLOUT, reply_timeout);
        if (!ready)
            return fail(ready.error());
        if (!*ready)
            return fail(plain_error(ErrorKind::InputOutput, "the service does not read its input"));
        // The far end has room, or waits until its replies are read, or has closed the connection.
        // A read tells which.
        if (const auto more = read_more(); !more)
            return fail(more.error());
    }
    return {};
}

Result<std::optional<std::string>> Connection::receive(std::chrono::milliseconds timeout)
{
    return receive(timeout, Clock::now() + longest_wait);
}

Result<std::optional<std::string>> Connection::receive(std::chrono::milliseconds timeout,
                                                       Clock::time_point give_up)
{
    for (std::size_t searched = 0;;) {
        if (const std::size_t end = received_.find('\n', searched); end != std::string::npos) {
            std::string line = received_.substr(0, end);
            received_.erase(0, end + 1);
            if (line.ends_with('\r'))
                line.pop_back();
            return line;
        }
        searched = received_.size();
        if (searched > longest_line || Clock::now() > give_up)
            return fail(
                plain_error(ErrorKind::InputOutput,
                            "the far end sends no line ends, so it does not use this protocol"));
        const auto ready = wait(POLLIN, timeout);
        if (!ready)
            return fail(ready.error());
        if (!*ready)
            return std::nullopt;
        if (const auto more = read_more(); !more)
            return fail(more.error());
    }
}

Error Connection::no_reply(std::string_view line) const
{
    std::string text = fmt::format("no reply to '{}' came in time", visible(line));
    if (far_end_ == FarEnd::OnlyErrors)
        text += "; the far end sends only ERR replies (the service's setting replies), so the line "
                "had no error";
    else if (far_end_ == FarEnd::Silent)
        text += "; nothing answers at the far end, or the service's setting replies is none";
    if (!skipped_.empty())
        text += fmt::format("; the last line is not a reply to it: '{}'", visible(skipped_));
    return plain_error(ErrorKind::InputOutput, std::move(text));
}

bool Connection::is_late(std::string_view asked, std::string_view reply) const
{
    if (!has_right_mark(reply))
        return false;
    // The reply to a line without a mark has no mark. If there are several lines, only the last one
    // is checked, and an earlier one may have a mark.
    if (!has_mark(asked))
        return far_end_ != FarEnd::Unmarked && asked.find('\r') == std::string_view::npos;
    if (!word_.empty() && reply.find(word_) != std::string_view::npos)
        return true;
    // A far end that was silent may still reply to the ACCELERATOR of the first contact. That reply
    // has one word after OK; the reply to STATUS has more.
    constexpr std::string_view question = "ACCELERATOR";
    constexpr std::size_t ok_bytes = std::string_view("OK ").size();
    const bool names = accelerator_of(without_mark(reply)) != nullptr;
    return far_end_ == FarEnd::Silent && names &&
           reply.find(' ', ok_bytes) == std::string_view::npos &&
           !protocol::equal_ignoring_case(asked.substr(0, question.size()), question);
}

Result<std::vector<std::string>> Connection::collect(std::string_view line, std::size_t due,
                                                     bool marked)
{
    skipped_.clear();
    std::vector<std::string> replies;
    auto give_up = Clock::now() + longest_wait;
    while (due > 0) {
        auto came = receive(line_timeout(), give_up);
        if (!came)
            return fail(came.error());
        if (!*came || Clock::now() > give_up)
            return fail(no_reply(line));
        std::string& reply = **came;
        if (!is_reply(reply) || is_late(line, reply) || (marked && !has_right_mark(reply))) {
            if (reply != line) // a far end that echoes sends the line back
                skipped_ = std::move(reply);
            continue;
        }
        if (far_end_ == FarEnd::Silent)
            far_end_ = has_right_mark(reply) ? FarEnd::Speaks : FarEnd::Unmarked;
        due -= ends_reply(reply) ? 1 : 0;
        give_up = Clock::now() + longest_wait;
        replies.push_back(std::move(reply));
    }
    return replies;
}

Result<std::vector<std::string>> Connection::ask(std::string_view bytes)
{
    if (auto sent = send(std::string(bytes) + "\n"); !sent)
        return fail(sent.error());
    return collect(bytes, replies_due(bytes), false);
}

std::string Connection::request_line(std::string_view command) const
{
    return far_end_ == FarEnd::Unmarked ? std::string(command) : with_mark(command);
}

Result<std::string> Connection::request(std::string_view command)
{
    const std::string line = request_line(command);
    if (far_end_ == FarEnd::OnlyErrors) // no reply would come before the time-out
        return fail(no_reply(line));
    if (auto sent = send(line + "\n"); !sent)
        return fail(sent.error());
    const auto replies = collect(line, 1, far_end_ == FarEnd::Speaks);
    if (!replies)
        return fail(replies.error());
    return std::string(without_mark(replies->back()));
}

Result<std::string> ask_and_print(Connection& connection, std::string_view bytes)
{
    const auto replies = connection.ask(bytes);
    if (!replies)
        return fail(replies.error());
    for (const std::string& reply : *replies)
        fmt::print("{}\n", reply);
    return replies->empty() ? std::string() : std::string(without_mark(replies->back()));
}

int report(Connection& connection, const Error& error)
{
    if (const int number = connection.interrupted(); number != 0)
        return status_of_signal + number;
    return report(error);
}

} // namespace raymarch::cli
