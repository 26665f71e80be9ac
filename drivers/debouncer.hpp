// SPDX-License-Identifier: MIT
/// @file
/// From the edges of a bouncing contact to presses and releases. No clock of its own: it compares
/// the times of the edges, so that nothing is lost when they are read late and together.
#pragma once

#include <chrono>
#include <optional>

namespace raymarch::drivers
{

/// A level counts once it has lasted for `settle`.
class Debouncer
{
  public:
    using Time = std::chrono::nanoseconds;

    /// `level` is taken to have lasted already.
    Debouncer(Time settle, bool level) noexcept : settle_(settle), level_(level), latest_(level) {}

    /// The level that counts.
    [[nodiscard]] bool level() const noexcept { return level_; }

    /// An edge to `level` at `at`. What it says of the level before it: the new level that counts,
    /// or nothing when that has not changed. Call it for each edge, in their order.
    [[nodiscard]] std::optional<bool> edge(bool level, Time at) noexcept
    {
        const std::optional<bool> lasted =
            at - since_ >= settle_ ? count(latest_) : std::optional<bool>();
        latest_ = level;
        since_ = at;
        return lasted;
    }

    /// No edge has come for `settle`, and the line reads `level`: the new level that counts, or
    /// nothing when that has not changed. Edges that the system dropped are made up for here.
    [[nodiscard]] std::optional<bool> quiet(bool level) noexcept
    {
        latest_ = level;
        return count(level);
    }

  private:
    std::optional<bool> count(bool level) noexcept
    {
        if (level == level_)
            return std::nullopt;
        level_ = level;
        return level;
    }

    Time settle_;
    bool level_;  ///< that counts
    bool latest_; ///< after the newest edge, at since_
    Time since_{};
};

} // namespace raymarch::drivers
