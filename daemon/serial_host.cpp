// SPDX-License-Identifier: MIT
#include "daemon/serial_host.hpp"

#include "base/log.hpp"
#include "drivers/serial_port.hpp"

#include <sys/epoll.h>

#include <memory>
#include <utility>
#include <variant>

namespace raymarch::daemon
{
namespace
{

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

SerialHost::SerialHost(const SerialWhere& where, EventLoop& loop, Turns& turns,
                       Controller& controller)
    : where_(where)
    , loop_(loop)
    , turns_(turns)
    , controller_(controller)
    , again_(loop, "no serial host", [this] { open(); })
    , link_again_(loop, "no link to the pseudo-terminal", [this] { mend_link(); })
    , link_(loop, [this] { look_at_link(); })
{}

SerialHost::~SerialHost() = default;

void SerialHost::open()
{
    auto port = std::visit(SerialOpener{}, where_);
    if (port && *port == nullptr)
        return;
    if (port) {
        terminal_ = dynamic_cast<drivers::PseudoTerminal*>(port->get());
        endpoint_.emplace(loop_, turns_, Rank::First, std::move(*port), controller_,
                          [this](Endpoint&) { lose(); });
        if (const auto problem = loop_.take_problem()) {
            drop();
            port = fail(*problem);
        }
    }
    if (!port)
        return again_.missing(port.error());
    again_.found();
    link_away_ = false;
    if (terminal_ != nullptr)
        watch_terminal();
}

void SerialHost::lose()
{
    log::warning("the serial port has gone away; it will be looked for");
    dropped_before_ += endpoint_->session().dropped_replies();
    hang_ups_before_ += endpoint_->session().hang_ups();
    drop();
    again_.lost();
}

void SerialHost::drop()
{
    visits_.reset();
    terminal_ = nullptr;
    endpoint_.reset();
}

void SerialHost::watch_terminal()
{
    link_.watch(std::get<PseudoTerminalLink>(where_).link);
    std::optional<Error> problem =
        plain_error(ErrorKind::Unavailable, "inotify does not watch the terminal");
    if (terminal_->visits_fd() >= 0) {
        visits_ = loop_.add_io(terminal_->visits_fd(), EPOLLIN,
                               [this](std::uint32_t) { terminal_->look(); });
        problem = loop_.take_problem();
    }
    if (problem)
        log::info("hosts that follow one another at once will not be told apart: {}",
                  problem->message);
}

void SerialHost::look_at_link()
{
    if (terminal_ == nullptr || terminal_->link_in_place() || std::exchange(link_away_, true))
        return;
    log::warning("the link to the pseudo-terminal, {}, was removed or replaced; it will be made "
                 "again",
                 std::get<PseudoTerminalLink>(where_).link);
    link_again_.lost();
}

void SerialHost::mend_link()
{
    if (terminal_ == nullptr)
        return; // the next terminal makes its own link
    if (const auto restored = terminal_->restore_link(); !restored)
        return link_again_.missing(restored.error());
    link_away_ = false;
    link_again_.found();
    link_.watch(std::get<PseudoTerminalLink>(where_).link);
}

void SerialHost::resume()
{
    if (endpoint_)
        endpoint_->resume();
}

std::string SerialHost::place() const
{
    const bool there = endpoint_ || std::holds_alternative<NoSerial>(where_);
    return to_text(where_) + (there ? "" : " (not there yet)");
}

std::uint64_t SerialHost::dropped_replies() const
{
    return dropped_before_ + (endpoint_ ? endpoint_->session().dropped_replies() : 0);
}

void SerialHost::write_status(protocol::StatusValues& status) const
{
    using protocol::StatusKey;
    const bool wanted = !std::holds_alternative<NoSerial>(where_);
    const bool up = endpoint_ && !link_away_;
    status.put(StatusKey::Serial, up ? "up" : wanted ? "down" : "none");
    if (up)
        status.put(StatusKey::HangUps, hang_ups_before_ + endpoint_->session().hang_ups());
}

} // namespace raymarch::daemon
