// SPDX-License-Identifier: MIT
#include "daemon/hosts.hpp"

#include "base/log.hpp"
#include "drivers/serial_port.hpp"

#include <sys/epoll.h>

#include <filesystem>
#include <memory>
#include <string>
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

Hosts::Hosts(const Config& config, EventLoop& loop, Turns& turns, Controller& controller)
    : config_(config)
    , loop_(loop)
    , turns_(turns)
    , controller_(controller)
    , look_(loop.add_timer([this] { look_at_places(); }))
    , serial_again_(loop, "no serial host", [this] { open_serial(); })
    , link_again_(loop, "no link to the pseudo-terminal", [this] { mend_link(); })
    , control_again_(loop, "no control socket", [this] { open_control(); })
    , accept_again_(loop, "a client of the control socket cannot be served",
                    [this] {
                        if (accept_)
                            accept_->watch(EPOLLIN);
                    })
    , log_turned_away_(loop.add_timer([this] { count_turned_away(); }))
{}

Hosts::~Hosts() = default;

// --- the serial port ---

void Hosts::open_serial()
{
    auto port = std::visit(SerialOpener{}, config_.serial);
    if (port && *port == nullptr)
        return;
    if (port) {
        terminal_ = dynamic_cast<drivers::PseudoTerminal*>(port->get());
        serial_.emplace(loop_, turns_, Rank::First, std::move(*port), controller_,
                        [this](Endpoint& gone) {
                            log::warning("the serial port has gone away; it will be looked for");
                            dropped_before_ += gone.session().dropped_replies();
                            hang_ups_before_ += gone.session().hang_ups();
                            drop_serial();
                            serial_again_.lost();
                        });
        if (const auto problem = loop_.take_problem()) {
            drop_serial();
            port = fail(*problem);
        }
    }
    if (!port)
        return serial_again_.missing(port.error());
    serial_again_.found();
    link_away_ = false;
    if (terminal_ != nullptr)
        watch_terminal();
}

void Hosts::watch_terminal()
{
    watch_link_ = watch_place(std::get<PseudoTerminalLink>(config_.serial).link);
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

void Hosts::drop_serial()
{
    visits_.reset();
    terminal_ = nullptr;
    serial_.reset();
}

// --- what others do to the socket and the link ---

/// Watches the folder of `path` for changes of the folder itself or of the entry with that name.
/// The handler only arms a timer: what the timer does may destroy the source, which the source's
/// own handler must not do.
Source Hosts::watch_place(const std::string& path)
{
    const std::filesystem::path place = std::filesystem::absolute(path);
    constexpr std::uint32_t changes = IN_CREATE | IN_DELETE | IN_MOVED_FROM | IN_MOVED_TO |
                                      IN_DELETE_SELF | IN_MOVE_SELF | IN_ONLYDIR;
    Source watch = loop_.add_inotify(
        place.parent_path().c_str(), changes,
        [this, name = place.filename().string()](const inotify_event& event) {
            if (event.len == 0 || name == event.name) // NOLINT(*-array-to-pointer-decay): C's
                look_->arm({});
        });
    if (const auto problem = loop_.take_problem())
        log::info("{}: it will not be noticed when it is removed: {}", path, problem->message);
    look_->arm({}); // something may have changed before the watch began
    return watch;
}

void Hosts::look_at_places()
{
    if (listener_ && !listener_->in_place()) {
        log::warning("the control socket {} was removed or replaced; it will be made again",
                     config_.control);
        accept_.reset();
        listener_.reset(); // connected clients stay connected
        control_again_.lost();
    }
    if (terminal_ != nullptr && !terminal_->link_in_place() && !std::exchange(link_away_, true)) {
        log::warning(
            "the link to the pseudo-terminal, {}, was removed or replaced; it will be made "
            "again",
            std::get<PseudoTerminalLink>(config_.serial).link);
        link_again_.lost();
    }
}

void Hosts::mend_link()
{
    if (terminal_ == nullptr)
        return; // the next terminal makes its own link
    if (const auto restored = terminal_->restore_link(); !restored)
        return link_again_.missing(restored.error());
    link_away_ = false;
    link_again_.found();
    watch_link_ = watch_place(std::get<PseudoTerminalLink>(config_.serial).link);
}

std::string Hosts::places() const
{
    const auto place = [](const std::string& name, bool there) {
        return name + (there ? "" : " (not there yet)");
    };
    const bool no_serial = std::holds_alternative<NoSerial>(config_.serial);
    return "serial: " + place(to_text(config_.serial), no_serial || serial_) + "; control: " +
           (config_.control.empty() ? "none" : place(config_.control, listener_.has_value()));
}

void Hosts::resume()
{
    for (Endpoint& client : clients_)
        client.resume();
    if (serial_)
        serial_->resume();
}

// --- STATUS ---

void Hosts::write_status(protocol::StatusValues& status) const
{
    using protocol::StatusKey;
    const bool wants_serial = !std::holds_alternative<NoSerial>(config_.serial);
    const bool up = serial_ && !link_away_;
    status.put(StatusKey::Serial, up ? "up" : wants_serial ? "down" : "none");
    if (up)
        status.put(StatusKey::HangUps, hang_ups_before_ + serial_->session().hang_ups());

    std::uint64_t dropped = dropped_before_;
    if (serial_)
        dropped += serial_->session().dropped_replies();
    for (const Endpoint& client : clients_)
        dropped += client.session().dropped_replies();
    status.put(StatusKey::Clients, clients_.size());
    status.put(StatusKey::DroppedReplies, dropped);
}

} // namespace raymarch::daemon
