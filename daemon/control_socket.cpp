// SPDX-License-Identifier: MIT
#include "daemon/control_socket.hpp"

#include "base/log.hpp"

#include <sys/epoll.h>

#include <algorithm>
#include <chrono>
#include <string_view>
#include <utility>

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

} // namespace

ControlSocket::ControlSocket(const Config& config, EventLoop& loop, Turns& turns,
                             Controller& controller)
    : config_(config)
    , loop_(loop)
    , turns_(turns)
    , controller_(controller)
    , again_(loop, "no control socket", [this] { open(); })
    , socket_(loop, [this] { look_at_socket(); })
    , accept_again_(loop, "a client of the control socket cannot be served",
                    [this] {
                        if (accept_)
                            accept_->watch(EPOLLIN);
                    })
    , log_turned_away_(loop.add_timer([this] { count_turned_away(); }))
{}

ControlSocket::~ControlSocket() = default;

void ControlSocket::open()
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
        return again_.missing(listener.error());
    again_.found();
    socket_.watch(config_.control);
}

void ControlSocket::look_at_socket()
{
    if (!listener_ || listener_->in_place())
        return;
    log::warning("the control socket {} was removed or replaced; it will be made again",
                 config_.control);
    accept_.reset();
    listener_.reset(); // connected clients stay connected
    again_.lost();
}

/// Stops watching the socket for a while, because a client that cannot be accepted keeps it
/// readable and would wake the loop again and again.
void ControlSocket::pause_accepting(const Error& problem)
{
    accept_->watch(0);
    if (!std::exchange(accept_pauses_, true))
        accept_again_.some_lost();
    accept_again_.missing(problem);
}

void ControlSocket::accept_client()
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

void ControlSocket::forget(Endpoint& client)
{
    client.drop_output();
    dropped_before_ += client.session().dropped_replies();
    clients_.remove_if([&](const Endpoint& other) { return &other == &client; });
}

/// Removes one client, so that a new one can be served. A client that has gone, and whose lines are
/// all done, is removed first. Without one, the client that has been silent longest is removed, if
/// that is longest_silence at least. A client that is connected and waits for the service does not
/// count as silent. Returns false when no client can be removed.
bool ControlSocket::make_room()
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
void ControlSocket::turn_away(drivers::BytePort& port)
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
void ControlSocket::count_turned_away()
{
    full_was_logged_ = turned_away_ > 0;
    if (!full_was_logged_)
        return;
    log::warning("{} more clients were turned away", std::exchange(turned_away_, 0));
    log_turned_away_->arm(turned_away_interval);
}

void ControlSocket::resume()
{
    for (Endpoint& client : clients_)
        client.resume();
}

std::string ControlSocket::place() const
{
    if (config_.control.empty())
        return "none";
    return config_.control + (listener_ ? "" : " (not there yet)");
}

std::uint64_t ControlSocket::dropped_replies() const
{
    std::uint64_t dropped = dropped_before_;
    for (const Endpoint& client : clients_)
        dropped += client.session().dropped_replies();
    return dropped;
}

} // namespace raymarch::daemon
