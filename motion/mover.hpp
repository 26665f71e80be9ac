// SPDX-License-Identifier: MIT
/// @file
/// The common interface of the movements of all accelerators. Each movement is a type `World` with
/// three pure functions: `enter` makes it from a state, `step` moves it, `leave` writes it back.
#pragma once

#include "motion/inputs.hpp"
#include "protocol/parameters.hpp"

#include <memory>
#include <optional>

namespace raymarch::motion
{

/// Moves a state, and remembers between steps what the state does not hold.
class Mover
{
  public:
    virtual ~Mover() = default;
    /// Makes one step. If the state differs from the one that the last step left, `enter` is called
    /// first.
    virtual void step(protocol::State& state, Inputs inputs) = 0;
};

/// The mover that calls the three functions of one accelerator.
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
    std::optional<protocol::State> left_; ///< the state after the last step
};

/// How one accelerator moves: one line of the registry in movers.hpp.
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
