// SPDX-License-Identifier: MIT
/// @file
/// Whose turn it is on the event loop: hosts that have something to do get it in short turns, so
/// that none of them holds up the others.
///
/// The serial port goes first, in every other turn at most. Among the others the host goes first
/// that has used the least time: one that asks little waits for one turn of another host, however
/// many others there are and whatever they ask for.
#pragma once

#include "daemon/event_loop.hpp"
#include "daemon/movement.hpp"

#include <array>
#include <chrono>
#include <functional>
#include <vector>

namespace raymarch::daemon
{

enum class Rank : std::uint8_t { First, Equal };

class Turns;

/// One host's place among the turns.
class Turn
{
  public:
    /// `take` does what there is to do until it is told that the turn is over, and says whether
    /// there is more; it may destroy this place.
    Turn(Turns& turns, Rank rank, std::function<bool(const TurnIsOver&)> take);
    Turn(const Turn&) = delete;
    Turn& operator=(const Turn&) = delete;
    ~Turn();

    /// There is something to do.
    void ready();

  private:
    friend class Turns;
    Turns& turns_;
    const Rank rank_;
    const std::function<bool(const TurnIsOver&)> take_;
    std::chrono::nanoseconds used_{}; ///< in its turns; after a pause, what the others have used
    bool waits_ = false;              ///< stands in turns_.waiting_
};

class Turns
{
  public:
    /// A turn ends at the first line or step of a movement that is done after this time.
    static constexpr std::chrono::milliseconds length{2};

    explicit Turns(EventLoop& loop) : loop_(loop) {}
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
    std::vector<Turn*> waiting_;
    Turn* running_ = nullptr;         ///< null also when it has been destroyed in its turn
    const Turn* last_ = nullptr;      ///< compared, never followed
    std::chrono::nanoseconds used_{}; ///< where a host that was silent starts: the most that an
                                      ///< equal host had used when its turn began
    bool soon_ = false;
    /// Two, used alternately: a source must not be replaced while its own handler runs.
    std::array<Source, 2> calls_;
    std::size_t call_ = 0;
};

} // namespace raymarch::daemon
