// SPDX-License-Identifier: MIT
/// How the controller goes on with lines that take longer than a turn: SAVE and LOAD, WALK and
/// TURN.
#include "daemon/unfinished.hpp"

#include "daemon/controller.hpp"

#include <utility>

namespace raymarch::daemon
{

using namespace protocol; // NOLINT(google-build-using-namespace): as in controller.cpp

std::string_view Controller::resume(Unfinished& rest, const TurnIsOver& turn_is_over)
{
    const bool checksummed = rest.checksummed_;
    const auto* const stored = std::get_if<Unfinished::Stored>(&rest.what_);
    const bool writes = stored == nullptr || stored->what == Unfinished::Storing::Load;
    reply_.begin(checksummed);
    const Outcome fault = go_on(rest, turn_is_over);
    if (rest.any())
        return {};
    return settle(fault, writes, checksummed);
}

Controller::Outcome Controller::go_on(Unfinished& rest, const TurnIsOver& turn_is_over)
{
    if (std::holds_alternative<Unfinished::Moving>(rest.what_))
        return move_on(rest, turn_is_over);
    if (!rest.waits())
        return take_stored(rest);
    return std::nullopt;
}

/// Finishes a SAVE or a LOAD after the disk has answered.
Controller::Outcome Controller::take_stored(Unfinished& rest)
{
    auto stored = std::get<Unfinished::Stored>(std::exchange(rest.what_, std::monostate()));
    const std::optional<State> state = stored.state.get();
    if (!state)
        return Fault{.code = ErrorCode::Storage};
    if (stored.what == Unfinished::Storing::Save) {
        return ok();
    }
    if (auto fault = may_go_on(*stored.accelerator))
        return fault;
    return apply(*state, words_);
}

/// Whether a line that writes, and that came for this accelerator, may still do so.
Controller::Outcome Controller::may_go_on(const Accelerator& accelerator) const
{
    if (&accelerator != accelerator_)
        return Fault{.code = ErrorCode::Busy,
                     .allowed = "another host has switched the accelerator meanwhile"};
    if (locked_)
        return Fault{.code = ErrorCode::Locked};
    return std::nullopt;
}

Controller::Outcome Controller::move(const Steps& steps, const Call& call)
{
    Unfinished& rest = call.rest;
    rest.what_.emplace<Unfinished::Moving>(Unfinished::Moving{.accelerator = accelerator_,
                                                              .asked = steps,
                                                              .left = steps,
                                                              .change = changes_,
                                                              .state = state_,
                                                              .before = words_,
                                                              .movement = std::move(movement_)});
    return move_on(rest, call.turn_is_over);
}

/// Gives the movement back to the controller, which keeps its memory for the next one.
void Controller::end_movement(Unfinished& rest)
{
    movement_ = std::move(std::get<Unfinished::Moving>(rest.what_).movement);
    rest.what_ = std::monostate();
}

/// If nobody else changes the state, the board gets one update, after the last step. If somebody
/// does, the steps that were not yet written are made again from the new state. From then on each
/// turn writes its steps, so that both changes take effect. Only the last update is checked for its
/// basis, counted and answered.
Controller::Outcome Controller::move_on(Unfinished& rest, const TurnIsOver& turn_is_over)
{
    auto& moving = std::get<Unfinished::Moving>(rest.what_);
    if (auto fault = may_go_on(*moving.accelerator)) {
        end_movement(rest);
        return fault;
    }
    if (moving.change != changes_) {
        moving.state = state_;
        moving.left = moving.asked;
        moving.disturbed = true;
    }
    moving.movement.move(*accelerator_, moving.state, moving.left, turn_is_over);
    if (moving.left.count > 0 && moving.disturbed && !write_state(moving.state, words_)) {
        end_movement(rest);
        return Fault{.code = ErrorCode::Hardware};
    }
    moving.change = changes_;
    if (moving.disturbed)
        moving.asked = moving.left;
    if (moving.left.count > 0)
        return std::nullopt;
    const State state = moving.state;
    const Words before = moving.before;
    end_movement(rest);
    return apply(state, before);
}

} // namespace raymarch::daemon
