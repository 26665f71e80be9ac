// SPDX-License-Identifier: MIT
#include "daemon/hosts.hpp"

#include "base/log.hpp"
#include "drivers/serial_port.hpp"

#include <sys/epoll.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <memory>
#include <string_view>
#include <utility>
#include <variant>

namespace raymarch::daemon
{
namespace
{

constexpr std::size_t max_clients = 16;
constexpr std::string_view too_many_clients = "there are 16 clients already";
static_assert(max_clients == 16); // the text says it
/// A client that has been silent for this long is removed for a new one when there are max_clients.
constexpr std::chrono::seconds longest_silence{10};
/// Clients that are turned away are logged at most this often.
constexpr std::chrono::seconds turned_away_interval{30};

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

// --- the control socket ---

void Hosts::open_control()
{
    if (config_.control.empty() || listener_)
        return;
    auto listener = drivers::SocketListener::open(config_.control);
    if (listener) {
        listener_.emplace(std::move(*listener));
        accept_ =
            loop_.add_io(listener_->fd(), EPOLLIN, [this](std::uint32_t) { accept_client(); });
        if (const auto problem = loop_.take_problem()) {
            listener_.reset();
            listener = fail(*problem);
        }
    }
    if (!listener)
        return control_again_.missing(listener.error());
    control_again_.found();
    watch_control_ = watch_place(config_.control);
}

/// Stops watching the socket for a while, because a client that cannot be accepted keeps it
/// readable and would wake the loop again and again.
void Hosts::pause_accepting(const Error& problem)
{
    accept_->watch(0);
    if (!std::exchange(accept_pauses_, true))
        accept_again_.some_lost();
    accept_again_.missing(problem);
}

void Hosts::accept_client()
{
    auto port = listener_->accept();
    if (!port)
        return pause_accepting(port.error());
    if (*port == nullptr)
        return;
    if (clients_.size() >= max_clients && !make_room())
        return turn_away(**port);
    clients_.emplace_back(loop_, turns_, Rank::Equal, std::move(*port), controller_,
                          [this](Endpoint& gone) { forget(gone); });
    if (const auto problem = loop_.take_problem()) {
        forget(clients_.back());
        return pause_accepting(*problem);
    }
    if (std::exchange(accept_pauses_, false))
        accept_again_.found();
}

void Hosts::forget(Endpoint& client)
{
    client.drop_output();
    dropped_before_ += client.session().dropped_replies();
    clients_.remove_if([&](const Endpoint& other) { return &other == &client; });
}

/// Removes one client, so that a new one can be served. A client that has gone, and whose lines are
/// all done, is removed first. Without one, the client that has been silent longest is removed, if
/// that is longest_silence at least. A client that is connected and waits for the service does not
/// count as silent. Returns false when no client can be removed.
bool Hosts::make_room()
{
    const auto left = std::ranges::find_if(
        clients_, [](const Endpoint& client) { return client.has_gone() && !client.busy(); });
    if (left != clients_.end()) {
        forget(*left);
        return true;
    }
    const auto now = std::chrono::steady_clock::now();
    Endpoint* silent = nullptr;
    for (Endpoint& client : clients_) {
        const bool gives_way =
            now - client.last_heard() >= longest_silence && (client.has_gone() || !client.busy());
        if (gives_way && (silent == nullptr || client.last_heard() < silent->last_heard()))
            silent = &client;
    }
    if (silent == nullptr)
        return false;
    log::info("the client that has been silent longest gives way to a new one");
    forget(*silent);
    return true;
}

/// Sends the reason once, and does not wait for the client to read it.
void Hosts::turn_away(drivers::BytePort& port)
{
    if (config_.replies != Replies::None) {
        protocol::ReplyWriter reply;
        reply.begin(false);
        protocol::write_fault(reply, controller_.accelerator(),
                              {.code = protocol::ErrorCode::Busy, .allowed = too_many_clients});
        static_cast<void>(port.write(reply.text()));
    }
    ++turned_away_;
    if (std::exchange(full_was_logged_, true))
        return;
    log::warning("a client was turned away: {}", too_many_clients);
    turned_away_ = 0;
    log_turned_away_->arm(turned_away_interval);
}

/// Logs one line for all clients that were turned away since the last one, so that clients that
/// come fast do not fill the log.
void Hosts::count_turned_away()
{
    full_was_logged_ = turned_away_ > 0;
    if (!full_was_logged_)
        return;
    log::warning("{} more clients were turned away", std::exchange(turned_away_, 0));
    log_turned_away_->arm(turned_away_interval);
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

void Hosts::write_serial_status(protocol::ReplyWriter& reply) const
{
    const bool wants_serial = !std::holds_alternative<NoSerial>(config_.serial);
    const bool up = serial_ && !link_away_;
    reply << " serial=" << (up ? "up" : wants_serial ? "down" : "none");
    if (up)
        reply << " hang_ups=" << hang_ups_before_ + serial_->session().hang_ups();
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
