// SPDX-License-Identifier: MIT
/// @file
/// The hosts of the service: the serial port and the clients of the control socket, opened as the
/// configuration names them and looked for again when they are missing or go away.
/// (clients.cpp has the control socket and its clients.)
#pragma once

#include "daemon/config.hpp"
#include "daemon/controller.hpp"
#include "daemon/endpoint.hpp"
#include "daemon/event_loop.hpp"
#include "daemon/reopener.hpp"
#include "daemon/turns.hpp"
#include "drivers/pseudo_terminal.hpp"
#include "drivers/unix_socket.hpp"

#include <cstdint>
#include <list>
#include <optional>
#include <string>

namespace raymarch::daemon
{

class Hosts
{
  public:
    /// Borrows all four.
    Hosts(const Config& config, EventLoop& loop, Turns& turns, Controller& controller);
    Hosts(const Hosts&) = delete;
    Hosts& operator=(const Hosts&) = delete;
    ~Hosts();

    void open_serial();
    void open_control();

    /// `serial: …; control: …`: where hosts are listened to, and whether that is there.
    [[nodiscard]] std::string places() const;

    /// Whoever waits for a disk looks whether it is done.
    void resume();

    void write_status(protocol::StatusValues& status) const;

  private:
    void accept_client();
    void pause_accepting(const Error& problem);
    [[nodiscard]] bool make_room();
    void turn_away(drivers::BytePort& port);
    void count_turned_away();
    void forget(Endpoint& client);
    [[nodiscard]] Source watch_place(const std::string& path);
    void look_at_places();
    void mend_link();
    void watch_terminal();
    void drop_serial();

    const Config& config_;
    EventLoop& loop_;
    Turns& turns_;
    Controller& controller_;
    Source look_; ///< the socket or the link may have been removed or replaced

    std::optional<Endpoint> serial_;
    drivers::PseudoTerminal* terminal_ = nullptr; ///< the port of serial_, where it is one
    std::uint64_t dropped_before_ = 0;            ///< by connections that are gone
    std::uint64_t hang_ups_before_ = 0;           ///< of terminals that are gone
    Reopener serial_again_;

    bool link_away_ = false;
    Reopener link_again_;
    Source watch_link_;
    Source visits_; ///< hosts that come to terminal_ and leave

    std::optional<drivers::SocketListener> listener_;
    Reopener control_again_;
    Source watch_control_;

    bool accept_pauses_ = false;
    Reopener accept_again_;
    Source accept_;
    std::uint64_t turned_away_ = 0; ///< since that was logged last
    bool full_was_logged_ = false;
    Source log_turned_away_;
    std::list<Endpoint> clients_;
};

} // namespace raymarch::daemon
