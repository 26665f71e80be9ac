// SPDX-License-Identifier: MIT
/// @file
/// Connects a byte port and its session to the event loop. The session works in turns.
#pragma once

#include "daemon/event_loop.hpp"
#include "daemon/session.hpp"
#include "daemon/turns.hpp"
#include "drivers/ports.hpp"

#include <array>
#include <chrono>
#include <cstdint>
#include <functional>
#include <memory>
#include <string_view>

namespace raymarch::daemon
{

class Endpoint
{
  public:
    /// The loop calls `on_gone` when the port cannot be used any more; it may destroy the endpoint.
    Endpoint(EventLoop& loop, Turns& turns, Rank rank, std::unique_ptr<drivers::BytePort> port,
             Controller& controller, std::function<void(Endpoint&)> on_gone);

    /// Call this function when a disk that a line waits for may be done.
    void resume() { turn_.ready(); }

    [[nodiscard]] const Session& session() const noexcept { return session_; }
    /// Drops the replies that the host has not read.
    void drop_output() noexcept { session_.drop_output(); }
    /// Returns when the host last sent or read bytes, or when the endpoint was made.
    [[nodiscard]] std::chrono::steady_clock::time_point last_heard() const noexcept
    {
        return last_heard_;
    }

    /// Returns whether a line of this host is in progress or waits.
    [[nodiscard]] bool busy() const;
    /// Returns whether the host has closed the port.
    [[nodiscard]] bool has_gone() const;

  private:
    /// The end of the input. It is handled after the bytes that came before it.
    enum class End : std::uint8_t { None, HungUp, Gone };

    [[nodiscard]] bool take_turn(const TurnIsOver& turn_is_over);
    [[nodiscard]] bool read();
    void read_ahead();
    [[nodiscard]] bool finish_input();
    void send();
    void start_send_timer();
    void send_timed_out();
    void leave();

    std::unique_ptr<drivers::BytePort> port_;
    Session session_;
    std::function<void(Endpoint&)> on_gone_;
    std::array<char, 16'384> buffer_;
    std::string_view input_; ///< the part of the buffer that the session has not taken
    End end_ = End::None;
    bool waits_for_room_ = false; ///< the loop reports when the port has room
    bool send_timer_runs_ = false;
    bool progress_ = false; ///< bytes were sent since the timer started
    std::chrono::steady_clock::time_point last_heard_ = std::chrono::steady_clock::now();
    Turn turn_;
    Source send_timer_;
    Source source_; ///< declared last: its handler uses all members above
};

} // namespace raymarch::daemon
