// SPDX-License-Identifier: MIT
/// @file
/// A Pin without a board: a level in memory, and edges that a test makes.
#pragma once

#include "drivers/ports.hpp"

#include <sys/eventfd.h>
#include <unistd.h>

#include <chrono>
#include <cstdint>
#include <deque>
#include <optional>
#include <utility>

namespace raymarch::test
{

class MemoryPin final : public drivers::Pin
{
  public:
    MemoryPin() : edges_(::eventfd(0, EFD_NONBLOCK | EFD_CLOEXEC)) {}
    ~MemoryPin() override { ::close(edges_); }

    [[nodiscard]] Result<bool> read() override { return level_; }
    [[nodiscard]] Result<void> write(bool on) override
    {
        level_ = on;
        return {};
    }
    [[nodiscard]] int edge_fd() const noexcept override { return edges_; }
    [[nodiscard]] Result<std::optional<drivers::Edge>> take_edge() override
    {
        std::uint64_t ignored = 0;
        [[maybe_unused]] const auto read = ::read(edges_, &ignored, sizeof ignored);
        if (waiting_.empty())
            return std::optional<drivers::Edge>();
        const drivers::Edge next = waiting_.front();
        waiting_.pop_front();
        wake(!waiting_.empty());
        return std::optional(next);
    }

    /// Somebody presses or lets go, at a time of the line's own clock.
    void drive(bool on, std::chrono::nanoseconds at = {})
    {
        if (on != std::exchange(level_, on))
            waiting_.push_back({on, at});
        wake(!waiting_.empty());
    }

  private:
    void wake(bool wanted) const
    {
        const std::uint64_t one = 1;
        if (wanted) [[maybe_unused]]
            const auto written = ::write(edges_, &one, sizeof one);
    }

    int edges_;
    std::deque<drivers::Edge> waiting_;
    bool level_ = false;
};

} // namespace raymarch::test
