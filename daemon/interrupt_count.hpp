// SPDX-License-Identifier: MIT
/// @file
/// Counts interrupts, and how many of them were coalesced.
#pragma once

#include <cstdint>
#include <optional>

namespace raymarch::daemon
{

/// A UIO device counts its interrupts modulo 2^32. If it is read late, the count has risen by more
/// than one: the interrupts were coalesced.
class InterruptCount
{
  public:
    /// A device was opened: its first count stands for one interrupt.
    void opened() noexcept { last_.reset(); }

    void take(std::uint32_t count) noexcept
    {
        const std::uint32_t fresh = last_ ? count - *last_ : 1;
        last_ = count;
        taken_ += fresh;
        missed_ += fresh > 0 ? fresh - 1 : 0;
    }

    [[nodiscard]] std::uint64_t taken() const noexcept { return taken_; }
    /// Returns how many interrupts were coalesced with a later one.
    [[nodiscard]] std::uint64_t missed() const noexcept { return missed_; }

  private:
    std::optional<std::uint32_t> last_;
    std::uint64_t taken_ = 0;
    std::uint64_t missed_ = 0;
};

} // namespace raymarch::daemon
