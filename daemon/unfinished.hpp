// SPDX-License-Identifier: MIT
/// @file
/// A line that takes longer than one turn of its host: a disk works on it, or it has many steps.
#pragma once

#include "daemon/movement.hpp"
#include "protocol/commands.hpp"
#include "protocol/parameters.hpp"
#include "protocol/registers.hpp"

#include <chrono>
#include <cstdint>
#include <future>
#include <optional>
#include <utility>
#include <variant>

namespace raymarch::daemon
{

/// A state that a disk is asked for or given. It is there when the disk is done.
using StoredState = std::future<std::optional<protocol::State>>;

/// One that is there at once.
[[nodiscard]] inline StoredState stored_already(std::optional<protocol::State> state)
{
    std::promise<std::optional<protocol::State>> promise;
    promise.set_value(std::move(state));
    return promise.get_future();
}

/// The part of a line that is still to be executed: a disk works on it, or a movement was left for
/// other hosts' turns. The host's next line waits for it.
class Unfinished
{
  public:
    /// Whether there is anything left.
    [[nodiscard]] bool any() const noexcept
    {
        return !std::holds_alternative<std::monostate>(what_);
    }
    /// Whether a disk is working on it, so that there is nothing to do yet.
    [[nodiscard]] bool waits() const
    {
        const auto* const stored = std::get_if<Stored>(&what_);
        return stored != nullptr &&
               stored->state.wait_for(std::chrono::seconds{0}) != std::future_status::ready;
    }

  private:
    friend class Controller;

    /// SAVE or LOAD.
    struct Stored
    {
        protocol::CommandId command;
        const protocol::Accelerator* accelerator;
        StoredState state;
    };
    /// WALK or TURN.
    struct Moving
    {
        const protocol::Accelerator* accelerator;
        Steps asked;            ///< still to be made, counted from the state at `change`
        Steps left;             ///< of `asked`, not made yet
        std::uint64_t change;   ///< the controller's count of changes when `state` was taken
        bool disturbed = false; ///< others have changed the state since the line came
        protocol::State state;  ///< after the steps that were made
        protocol::Words before; ///< when the line came
        Movement movement;
    };
    std::variant<std::monostate, Stored, Moving> what_;
    bool checksummed_ = false;
};

} // namespace raymarch::daemon
