// SPDX-License-Identifier: MIT
/// @file
/// A Pin without a board: a level in memory, and edges that a test makes.
#pragma once

#include "drivers/ports.hpp"

#include <sys/eventfd.h>
#include <unistd.h>

#include <cstdint>

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

    /// Somebody presses or lets go.
    void drive(bool on)
    {
        const std::uint64_t one = on == level_ ? 0 : 1;
        level_ = on;
        if (one != 0) [[maybe_unused]]
            const auto written = ::write(edges_, &one, sizeof one);
    }

  private:
    int edges_;
    bool level_ = false;
};

} // namespace raymarch::test
