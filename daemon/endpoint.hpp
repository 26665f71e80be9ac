// SPDX-License-Identifier: MIT
/// @file
/// A byte port in the event loop with the session on it.
#pragma once

#include "daemon/event_loop.hpp"
#include "daemon/session.hpp"
#include "drivers/ports.hpp"

#include <chrono>
#include <functional>
#include <memory>

namespace raymarch::daemon
{

class Endpoint
{
  public:
    /// `on_gone` is called, from the loop, when the port is of no use any more; it may destroy the
    /// endpoint.
    Endpoint(EventLoop& loop, std::unique_ptr<drivers::BytePort> port, Controller& controller,
             std::function<void(Endpoint&)> on_gone);

    [[nodiscard]] const Session& session() const noexcept { return session_; }
    /// When the host said something last, or came.
    [[nodiscard]] std::chrono::steady_clock::time_point last_heard() const { return last_heard_; }

  private:
    void on_ready(std::uint32_t events);
    /// False when the port has gone.
    [[nodiscard]] bool receive();
    void send();

    std::unique_ptr<drivers::BytePort> port_;
    Session session_;
    std::function<void(Endpoint&)> on_gone_;
    bool waits_for_room_ = false;
    std::chrono::steady_clock::time_point last_heard_ = std::chrono::steady_clock::now();
    Source source_; ///< last: it calls into all of the above
};

} // namespace raymarch::daemon
