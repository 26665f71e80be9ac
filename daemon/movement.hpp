// SPDX-License-Identifier: MIT
/// @file
/// Moves the camera or the scene of whichever accelerator is active.
#pragma once

#include "daemon/turn_is_over.hpp"
#include "motion/mover.hpp"
#include "protocol/parameters.hpp"

#include <cstdint>
#include <memory>

namespace raymarch::daemon
{

/// Steps of a WALK or a TURN.
struct Steps
{
    motion::Inputs inputs;
    unsigned count = 1;
};
enum class Side : std::uint8_t { Left, Right };

class Movement
{
  public:
    /// Moves `state`, a state of `accelerator`, by `steps`, of which there is at least one; nothing
    /// where that accelerator does not move. `steps.count` is what is left when `turn_is_over` ends
    /// it early.
    void move(const protocol::Accelerator& accelerator, protocol::State& state, Steps& steps,
              const TurnIsOver& turn_is_over);
    /// One step of what moves by itself.
    void animate(const protocol::Accelerator& accelerator, protocol::State& state);
    /// One step of the camera to that side: a turn, or a step aside where nothing turns.
    void orbit(const protocol::Accelerator& accelerator, protocol::State& state, Side side);

  private:
    void step(const protocol::Accelerator& accelerator, protocol::State& state,
              motion::Inputs inputs);

    const protocol::Accelerator* accelerator_ = nullptr; ///< whose mover it is
    std::unique_ptr<motion::Mover> mover_;
};

} // namespace raymarch::daemon
