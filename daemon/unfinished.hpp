// SPDX-License-Identifier: MIT
/// @file
/// A line that takes longer than one turn of its host, because a disk works on it or because it is
/// a movement of many steps.
#pragma once

#include "daemon/movement.hpp"
#include "protocol/parameters.hpp"

#include <chrono>
#include <cstdint>
#include <future>
#include <optional>
#include <utility>
#include <variant>

namespace raymarch::daemon
{

/// A state that is being read from a disk or written to it. It is ready when the disk is done.
using StoredState = std::future<std::optional<protocol::State>>;

/// Makes a StoredState that is ready at once.
[[nodiscard]] inline StoredState stored_already(std::optional<protocol::State> state)
{
    std::promise<std::optional<protocol::State>> promise;
    promise.set_value(std::move(state));
    return promise.get_future();
}

/// The part of a line that has not been executed yet. Either a disk still works on it, or it is a
/// movement whose remaining steps are made in later turns of its host. The next line of that host
/// waits until this one is finished.
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

    enum class Storing : std::uint8_t { Save, Load };
    struct Stored
    {
        Storing what;
        const protocol::Accelerator* accelerator;
        StoredState state;
    };
    /// A WALK or a TURN.
    struct Moving
    {
        const protocol::Accelerator* accelerator;
        Steps asked;            ///< the steps to make from the last state that others can see
        Steps left;             ///< how many of `asked` are still to be made
        std::uint64_t change;   ///< the value of Controller::changes_ when `state` was taken
        bool disturbed = false; ///< whether others changed the state after the line came
        protocol::State state;  ///< the state after the steps that were made
        protocol::Words before; ///< the words when the line came
        Movement movement;
    };
    std::variant<std::monostate, Stored, Moving> what_;
    bool checksummed_ = false;
};

} // namespace raymarch::daemon
