// SPDX-License-Identifier: MIT
/// @file
/// Decides which host works next on the event loop. Hosts that have work get short turns, so that
/// no host delays the others for long.
///
/// The serial port goes before the other hosts, but gets every other turn at most. Among the other
/// hosts, the one that has used the least processor time goes first. So a host that asks for little
/// waits for about one turn of another host, however many there are and whatever they ask for.
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

/// One host, as Turns knows it.
class Turn
{
  public:
    /// `take` works until it is told that the turn is over, and returns whether there is more to
    /// do. It may destroy this Turn.
    Turn(Turns& turns, Rank rank, std::function<bool(const TurnIsOver&)> take);
    Turn(const Turn&) = delete;
    Turn& operator=(const Turn&) = delete;
    ~Turn();

    /// Tells that this host has something to do.
    void ready();

  private:
    friend class Turns;
    Turns& turns_;
    const Rank rank_;
    const std::function<bool(const TurnIsOver&)> take_;
    std::chrono::nanoseconds used_{}; ///< in its turns; after a pause, turns_.used_ at least
    bool waits_ = false;              ///< it is in turns_.waiting_
};

class Turns
{
  public:
    /// A turn ends at the first line or step of a movement that is done after this time.
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
    Turn* running_ = nullptr;         ///< null also when it has been destroyed in its turn
    const Turn* last_ = nullptr;      ///< compared, never followed
    std::chrono::nanoseconds used_{}; ///< a host that was silent starts with this: the most that
                                      ///< an equal host had used when its turn began
    bool soon_ = false;
    /// Two are used in turn, because a source must not be replaced while its own handler runs.
    std::array<Source, 2> calls_;
    std::size_t call_ = 0;
};

} // namespace raymarch::daemon
