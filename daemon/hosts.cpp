// SPDX-License-Identifier: MIT
#include "daemon/hosts.hpp"

#include "base/log.hpp"
#include "drivers/pseudo_terminal.hpp"
#include "drivers/serial_port.hpp"

#include <sys/epoll.h>

#include <memory>
#include <utility>
#include <variant>

namespace raymarch::daemon
{
namespace
{

constexpr std::size_t max_clients = 16;

using PortResult = Result<std::unique_ptr<drivers::BytePort>>;

struct SerialOpener
{
    PortResult operator()(const NoSerial&) const { return nullptr; }
    PortResult operator()(const SerialDevice& where) const
    {
        return drivers::SerialPort::open(where.path, where.baud);
    }
    PortResult operator()(const PseudoTerminalLink& where) const
    {
        return drivers::PseudoTerminal::open(where.link);
    }
};

} // namespace

Hosts::Hosts(const Config& config, EventLoop& loop, Turns& turns, Controller& controller)
    : config_(config)
    , loop_(loop)
    , turns_(turns)
    , controller_(controller)
    , retry_serial_(loop.add_timer([this] { open_serial(); }))
    , retry_control_(loop.add_timer([this] { open_control(); }))
{}

Hosts::~Hosts() = default;

void Hosts::log_once(std::string& last, const Error& error, const char* what)
{
    if (error.message != last)
        log::warning("{}: {}; it will be tried again", what, error.message);
    last = error.message;
}

void Hosts::open_serial()
{
    auto port = std::visit(SerialOpener{}, config_.serial);
    if (!port) {
        log_once(serial_problem_, port.error(), "no serial host");
        retry_serial_->arm(serial_back_off_.next());
        return;
    }
    if (*port == nullptr)
        return;
    serial_problem_.clear();
    serial_back_off_.opened();
    serial_.emplace(loop_, turns_, Rank::First, std::move(*port), controller_,
                    [this](Endpoint& gone) {
                        log::warning("the serial port has gone away; it will be looked for");
                        dropped_before_ += gone.session().dropped_replies();
                        serial_.reset();
                        serial_back_off_.lost();
                        retry_serial_->arm(serial_back_off_.next());
                    });
}

void Hosts::open_control()
{
    if (config_.control.empty())
        return;
    if (!listener_) {
        auto listener = drivers::SocketListener::open(config_.control);
        if (!listener) {
            log_once(control_problem_, listener.error(), "no control socket");
            retry_control_->arm(control_back_off_.next());
            return;
        }
        listener_.emplace(std::move(*listener));
        control_problem_.clear();
        control_back_off_.reset();
    }
    accept_ = loop_.add_io(listener_->fd(), EPOLLIN, [this](std::uint32_t) { accept_client(); });
}

void Hosts::accept_client()
{
    auto port = listener_->accept();
    if (!port) { // the client waits on, and would wake the loop again and again
        log_once(control_problem_, port.error(), "control socket");
        accept_.reset();
        retry_control_->arm(control_back_off_.next());
        return;
    }
    if (*port == nullptr)
        return;
    if (clients_.size() >= max_clients) {
        log::warning("a client was turned away: there are {} already", max_clients);
        return;
    }
    clients_.emplace_back(
        loop_, turns_, Rank::Equal, std::move(*port), controller_, [this](Endpoint& gone) {
            dropped_before_ += gone.session().dropped_replies();
            clients_.remove_if([&](const Endpoint& client) { return &client == &gone; });
        });
}

void Hosts::resume()
{
    for (Endpoint& client : clients_)
        client.resume();
    if (serial_)
        serial_->resume();
}

void Hosts::write_serial_status(protocol::ReplyWriter& reply) const
{
    const bool wants_serial = !std::holds_alternative<NoSerial>(config_.serial);
    reply << " serial=" << (serial_ ? "up" : wants_serial ? "down" : "none");
    if (serial_)
        reply << " hang_ups=" << serial_->session().hang_ups();
}

void Hosts::write_client_status(protocol::ReplyWriter& reply) const
{
    std::uint64_t dropped = dropped_before_;
    if (serial_)
        dropped += serial_->session().dropped_replies();
    for (const Endpoint& client : clients_)
        dropped += client.session().dropped_replies();
    reply << " clients=" << std::uint64_t{clients_.size()} << " dropped_replies=" << dropped;
}

} // namespace raymarch::daemon
