// SPDX-License-Identifier: MIT
/// @file
/// The control socket and its clients. The socket is made again when it is missing or goes away.
#pragma once

#include "daemon/config.hpp"
#include "daemon/controller.hpp"
#include "daemon/endpoint.hpp"
#include "daemon/event_loop.hpp"
#include "daemon/place_watch.hpp"
#include "daemon/reopener.hpp"
#include "daemon/turns.hpp"
#include "drivers/unix_socket.hpp"

#include <cstdint>
#include <list>
#include <optional>
#include <string>

namespace raymarch::daemon
{

class ControlSocket
{
  public:
    /// Borrows all four. Reads `control` and `replies` of the configuration.
    ControlSocket(const Config& config, EventLoop& loop, Turns& turns, Controller& controller);
    ControlSocket(const ControlSocket&) = delete;
    ControlSocket& operator=(const ControlSocket&) = delete;
    ~ControlSocket();

    void open();
    /// Goes on with the lines that wait for a disk.
    void resume();

    /// Where the socket is, and whether it is there.
    [[nodiscard]] std::string place() const;
    [[nodiscard]] std::size_t clients() const noexcept { return clients_.size(); }
    [[nodiscard]] std::uint64_t dropped_replies() const;

  private:
    void look_at_socket();
    void accept_client();
    void pause_accepting(const Error& problem);
    void forget(Endpoint& client);
    [[nodiscard]] bool make_room();
    void turn_away(drivers::BytePort& port);
    void count_turned_away();

    const Config& config_;
    EventLoop& loop_;
    Turns& turns_;
    Controller& controller_;

    std::optional<drivers::SocketListener> listener_;
    Reopener again_;
    PlaceWatch socket_;

    bool accept_pauses_ = false;
    Reopener accept_again_;
    Source accept_;
    std::uint64_t turned_away_ = 0; ///< since that was logged last
    bool full_was_logged_ = false;
    Source log_turned_away_;
    std::list<Endpoint> clients_;
    std::uint64_t dropped_before_ = 0; ///< by clients that are gone
};

} // namespace raymarch::daemon
