// SPDX-License-Identifier: MIT
/// @file
/// Turns the edges of a bouncing contact into presses and releases. It compares the times of the
/// edges and reads no clock, so no press is lost if several edges are read late.
#pragma once

#include <chrono>
#include <optional>

namespace raymarch::drivers
{

/// Accepts a level when it has been stable for `settle_time`.
class Debouncer
{
  public:
    using Time = std::chrono::nanoseconds;

    /// `level` is accepted at once.
    Debouncer(Time settle_time, bool level) noexcept
        : settle_time_(settle_time)
        , accepted_(level)
        , newest_(level)
    {}

    /// Returns the accepted level.
    [[nodiscard]] bool level() const noexcept { return accepted_; }

    /// Call this function for each edge in order. If the level before the edge was stable and is
    /// new, it is accepted and returned.
    [[nodiscard]] std::optional<bool> edge(bool level, Time at) noexcept
    {
        const std::optional<bool> stable =
            at - newest_edge_ >= settle_time_ ? accept(newest_) : std::optional<bool>();
        newest_ = level;
        newest_edge_ = at;
        return stable;
    }

    /// Call this function with the sampled level if no edge came for `settle_time`. A new level is
    /// accepted and returned, even if the system dropped its edge.
    [[nodiscard]] std::optional<bool> sample(bool level) noexcept
    {
        newest_ = level;
        return accept(level);
    }

  private:
    std::optional<bool> accept(bool level) noexcept
    {
        if (level == accepted_)
            return std::nullopt;
        accepted_ = level;
        return level;
    }

    Time settle_time_;
    bool accepted_;
    bool newest_; ///< the level after the newest edge
    Time newest_edge_{};
};

} // namespace raymarch::drivers
