// SPDX-License-Identifier: MIT
/// @file
/// One shape for the movements of all accelerators. Each is a value `World` with pure functions:
/// `enter` makes it from a state, `step` moves it, `leave` writes it back.
#pragma once

#include "motion/inputs.hpp"
#include "protocol/parameters.hpp"

#include <memory>
#include <optional>

namespace raymarch::motion
{

/// Moves a state, and remembers what the state does not hold.
class Mover
{
  public:
    virtual ~Mover() = default;
    /// A state that is not as the last step left it is entered afresh.
    virtual void step(protocol::State& state, Inputs inputs) = 0;
};

/// The mover made of three functions of one accelerator.
template <auto Enter, auto Step, auto Leave>
class WorldMover final : public Mover
{
  public:
    void step(protocol::State& state, Inputs inputs) override
    {
        if (!left_ || !(state == *left_))
            world_ = Enter(state);
        world_ = Step(world_, inputs);
        Leave(world_, state);
        left_ = state;
    }

  private:
    decltype(Enter(protocol::State())) world_;
    std::optional<protocol::State> left_; ///< as the last step left it
};

/// How one accelerator moves; a line of the registry (movers.hpp).
struct MoverRow
{
    const protocol::Accelerator* description;
    std::unique_ptr<Mover> (*make)();
};

template <auto Enter, auto Step, auto Leave>
[[nodiscard]] std::unique_ptr<Mover> make_mover()
{
    return std::make_unique<WorldMover<Enter, Step, Leave>>();
}

} // namespace raymarch::motion
