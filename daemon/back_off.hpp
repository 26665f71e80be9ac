// SPDX-License-Identifier: MIT
/// @file
/// The back-off between attempts to open something that is missing.
#pragma once

#include <algorithm>
#include <chrono>

namespace raymarch::daemon
{

/// The delay starts at 250 ms, doubles each time, and is at most 30 s. It starts again only after
/// something stayed open for the longest delay.
class BackOff
{
  public:
    using Clock = std::chrono::steady_clock;

    [[nodiscard]] std::chrono::milliseconds next() noexcept
    {
        const auto delay = delay_;
        delay_ = std::min(2 * delay_, longest);
        return delay;
    }
    void reset() noexcept { delay_ = first; }

    void opened(Clock::time_point now = Clock::now()) noexcept { opened_ = now; }
    void lost(Clock::time_point now = Clock::now()) noexcept
    {
        if (now - opened_ >= longest)
            reset();
    }

  private:
    static constexpr std::chrono::milliseconds first{250};
    static constexpr std::chrono::milliseconds longest{30'000};
    std::chrono::milliseconds delay_ = first;
    Clock::time_point opened_{};
};

} // namespace raymarch::daemon
