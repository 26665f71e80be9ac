// SPDX-License-Identifier: MIT
/// @file
/// WALK, TURN and ANIMATE: words to inputs, inputs to the movement of the active accelerator.
#pragma once

#include "daemon/turn_is_over.hpp"
#include "motion/mover.hpp"
#include "protocol/errors.hpp"
#include "protocol/text.hpp"

#include <cstdint>
#include <memory>
#include <tl/expected.hpp>

namespace raymarch::daemon
{

/// What WALK or TURN asks for.
struct Steps
{
    motion::Inputs inputs;
    unsigned count = 1;
};
/// `DIRECTION [STEPS]`. Errors: Argument.
[[nodiscard]] tl::expected<Steps, protocol::Fault> read_walk(protocol::Text words) noexcept;
[[nodiscard]] tl::expected<Steps, protocol::Fault> read_turn(protocol::Text words) noexcept;

/// `on [RATE]` or `off`: steps a second, 0 for off. Errors: Argument.
[[nodiscard]] tl::expected<unsigned, protocol::Fault> read_animate(protocol::Text words) noexcept;

enum class Side : std::uint8_t { Left, Right };

/// Steps a second that may be asked for.
inline constexpr unsigned most_rate = 60;

/// The movement of whichever accelerator is active.
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
