// SPDX-License-Identifier: MIT
#include "daemon/movement.hpp"

#include "motion/movers.hpp"

namespace raymarch::daemon
{

using motion::Input;

void Movement::step(const protocol::Accelerator& accelerator, protocol::State& state,
                    motion::Inputs inputs)
{
    if (!mover_ || accelerator_ != &accelerator) { // none yet, or a long movement has taken it
        mover_ = motion::mover_of(accelerator);
        accelerator_ = &accelerator;
    }
    mover_->step(state, inputs);
}

void Movement::move(const protocol::Accelerator& accelerator, protocol::State& state, Steps& steps,
                    const TurnIsOver& turn_is_over)
{
    do {
        step(accelerator, state, steps.inputs);
        --steps.count;
    } while (steps.count > 0 && !turn_is_over());
}

void Movement::animate(const protocol::Accelerator& accelerator, protocol::State& state)
{
    step(accelerator, state, Input::Animate);
}

void Movement::orbit(const protocol::Accelerator& accelerator, protocol::State& state, Side side)
{
    const bool left = side == Side::Left;
    const protocol::State before = state;
    step(accelerator, state, left ? Input::TurnLeft : Input::TurnRight);
    if (state == before)
        step(accelerator, state, left ? Input::StrafeLeft : Input::StrafeRight);
}

} // namespace raymarch::daemon
