// SPDX-License-Identifier: MIT
/// @file
/// Decides which host the event loop serves next. Hosts with work get short turns, so that no host
/// delays the others for long.
///
/// The serial port goes before the other hosts, but gets at most every second turn. Among the other
/// hosts, the one that has used the least processor time goes first. So a host with little work
/// waits for about one turn of another host, however many hosts there are.
#pragma once

#include "daemon/event_loop.hpp"
#include "daemon/turn_is_over.hpp"

#include <array>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

namespace raymarch::daemon
{

enum class Rank : std::uint8_t { First, Equal };

class Turns;

/// One host.
class Turn
{
  public:
    /// `take` works until the turn is over, and returns whether there is more to do. It may destroy
    /// this Turn.
    Turn(Turns& turns, Rank rank, std::function<bool(const TurnIsOver&)> take);
    Turn(const Turn&) = delete;
    Turn& operator=(const Turn&) = delete;
    ~Turn();

    /// Call this function when the host has something to do.
    void ready();

  private:
    friend class Turns;
    Turns& turns_;
    const Rank rank_;
    const std::function<bool(const TurnIsOver&)> take_;
    std::chrono::nanoseconds used_{}; ///< its processor time; after a pause at least turns_.used_
    bool waits_ = false;              ///< it is in turns_.waiting_
};

class Turns
{
  public:
    /// After this time, the turn ends with the present line or step of a movement.
    static constexpr std::chrono::milliseconds usual_length{2};

    explicit Turns(EventLoop& loop, std::chrono::nanoseconds length = usual_length)
        : loop_(loop)
        , length_(length)
    {}
    Turns(const Turns&) = delete;
    Turns& operator=(const Turns&) = delete;
    ~Turns() = default;

  private:
    friend class Turn;
    [[nodiscard]] Turn& next() const;
    void run_next();
    void run(Turn& turn);
    void run_soon();

    EventLoop& loop_;
    const std::chrono::nanoseconds length_;
    std::vector<Turn*> waiting_;
    Turn* running_ = nullptr;         ///< also null if it was destroyed in its turn
    const Turn* last_ = nullptr;      ///< may dangle, and is only compared
    std::chrono::nanoseconds used_{}; ///< a silent host starts with this: the largest time of an
                                      ///< equal host at the beginning of its turn
    bool soon_ = false;
    /// The two sources alternate, because a source must not be replaced while its handler runs.
    std::array<Source, 2> calls_;
    std::size_t call_ = 0;
};

} // namespace raymarch::daemon
