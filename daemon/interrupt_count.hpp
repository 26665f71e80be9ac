// SPDX-License-Identifier: MIT
/// @file
/// How many interrupts came, and how many of them nobody saw by themselves.
#pragma once

#include <cstdint>
#include <optional>

namespace raymarch::daemon
{

/// A device counts its interrupts from when its driver was loaded, modulo 2^32; who reads the count
/// late sees it jump.
class InterruptCount
{
  public:
    /// A device was opened: its first count stands for one interrupt, whatever came before.
    void opened() noexcept { last_.reset(); }

    void take(std::uint32_t count) noexcept
    {
        const std::uint32_t fresh = last_ ? count - *last_ : 1;
        last_ = count;
        taken_ += fresh;
        missed_ += fresh > 0 ? fresh - 1 : 0;
    }

    [[nodiscard]] std::uint64_t taken() const noexcept { return taken_; }
    /// Of those, the ones that came together with a later one.
    [[nodiscard]] std::uint64_t missed() const noexcept { return missed_; }

  private:
    std::optional<std::uint32_t> last_;
    std::uint64_t taken_ = 0;
    std::uint64_t missed_ = 0;
};

} // namespace raymarch::daemon
