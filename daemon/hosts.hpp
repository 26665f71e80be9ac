// SPDX-License-Identifier: MIT
/// @file
/// The hosts of the service: the serial port and the clients of the control socket, opened as the
/// configuration names them and looked for again when they are missing or go away.
#pragma once

#include "daemon/back_off.hpp"
#include "daemon/config.hpp"
#include "daemon/controller.hpp"
#include "daemon/endpoint.hpp"
#include "daemon/event_loop.hpp"
#include "daemon/turns.hpp"
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

    /// Whoever waits for a disk looks whether it is done.
    void resume();

    /// ` serial=… hang_ups=…`
    void write_serial_status(protocol::ReplyWriter& reply) const;
    /// ` clients=… dropped_replies=…`
    void write_client_status(protocol::ReplyWriter& reply) const;

  private:
    void accept_client();
    void log_once(std::string& last, const Error& error, const char* what);

    const Config& config_;
    EventLoop& loop_;
    Turns& turns_;
    Controller& controller_;

    std::optional<Endpoint> serial_;
    std::uint64_t dropped_before_ = 0; ///< by connections that are gone
    std::string serial_problem_;
    BackOff serial_back_off_;
    Source retry_serial_;

    std::optional<drivers::SocketListener> listener_;
    std::string control_problem_;
    BackOff control_back_off_;
    Source retry_control_;
    Source accept_;
    std::list<Endpoint> clients_;
};

} // namespace raymarch::daemon
