// SPDX-License-Identifier: MIT
/// @file
/// A byte port in the event loop with the session on it, which does its work in turns.
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
    /// `on_gone` is called, from the loop, when the port is of no use any more; it may destroy the
    /// endpoint.
    Endpoint(EventLoop& loop, Turns& turns, Rank rank, std::unique_ptr<drivers::BytePort> port,
             Controller& controller, std::function<void(Endpoint&)> on_gone);

    /// A disk that a line waited for may be done.
    void resume() { turn_.ready(); }

    [[nodiscard]] const Session& session() const noexcept { return session_; }
    /// The host will not read what still waits.
    void drop_output() noexcept { session_.drop_output(); }
    /// When the host sent bytes last, or took some; at first, when the endpoint was made.
    [[nodiscard]] std::chrono::steady_clock::time_point last_heard() const noexcept
    {
        return last_heard_;
    }

    /// Whether a line of this host is being worked on, or waits for that.
    [[nodiscard]] bool busy() const;
    /// Whether nobody is there to read a reply.
    [[nodiscard]] bool has_gone() const;

  private:
    /// What the port has said of the other side, to be acted on behind the bytes that came before.
    enum class End : std::uint8_t { None, HungUp, Gone };

    [[nodiscard]] bool take_turn(const TurnIsOver& turn_is_over);
    [[nodiscard]] bool read();
    void read_ahead();
    [[nodiscard]] bool finish_input();
    void send();
    void start_patience();
    void patience_is_over();
    void leave();

    std::unique_ptr<drivers::BytePort> port_;
    Session session_;
    std::function<void(Endpoint&)> on_gone_;
    std::array<char, 16'384> buffer_;
    std::string_view input_; ///< of the buffer: what the session has not taken yet
    End end_ = End::None;
    bool watches_room_ = false;   ///< the loop tells when the port takes bytes again
    bool measures_ = false;       ///< patience_ runs
    bool sent_meanwhile_ = false; ///< since it runs
    std::chrono::steady_clock::time_point last_heard_ = std::chrono::steady_clock::now();
    Turn turn_;
    Source patience_;
    Source source_; ///< last: it calls into all of the above
};

} // namespace raymarch::daemon
