// SPDX-License-Identifier: MIT
/// @file
/// The host at the serial port, which is a device or a pseudo-terminal with a link to it. The port
/// is looked for again when it is missing or goes away.
#pragma once

#include "daemon/config.hpp"
#include "daemon/controller.hpp"
#include "daemon/endpoint.hpp"
#include "daemon/event_loop.hpp"
#include "daemon/place_watch.hpp"
#include "daemon/reopener.hpp"
#include "daemon/turns.hpp"
#include "drivers/pseudo_terminal.hpp"

#include <cstdint>
#include <optional>
#include <string>

namespace raymarch::daemon
{

class SerialHost
{
  public:
    /// Borrows all four.
    SerialHost(const SerialWhere& where, EventLoop& loop, Turns& turns, Controller& controller);
    SerialHost(const SerialHost&) = delete;
    SerialHost& operator=(const SerialHost&) = delete;
    ~SerialHost();

    void open();
    /// Goes on with a line that waits for a disk.
    void resume();

    /// Where the port is, in the notation of the setting `serial`, and whether it is there.
    [[nodiscard]] std::string place() const;
    [[nodiscard]] std::uint64_t dropped_replies() const;
    void write_status(protocol::StatusValues& status) const;

  private:
    void lose();
    void drop();
    void watch_terminal();
    void look_at_link();
    void mend_link();

    const SerialWhere& where_;
    EventLoop& loop_;
    Turns& turns_;
    Controller& controller_;

    std::optional<Endpoint> endpoint_;
    drivers::PseudoTerminal* terminal_ = nullptr; ///< the port of endpoint_, where it is one
    std::uint64_t dropped_before_ = 0;            ///< by ports that are gone
    std::uint64_t hang_ups_before_ = 0;           ///< of terminals that are gone
    Reopener again_;
    Source visits_; ///< hosts that come to terminal_ and leave

    bool link_away_ = false;
    Reopener link_again_;
    PlaceWatch link_;
};

} // namespace raymarch::daemon
