// SPDX-License-Identifier: MIT
/// @file
/// How long to wait before something that is missing is looked for again.
#pragma once

#include <algorithm>
#include <chrono>

namespace raymarch::daemon
{

/// 250 ms at first, twice as long each time, 30 s at most. Something that is found and lost again
/// at once has not been worth the look: only what lasts takes the waiting back to its beginning.
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

    /// It was found; it was lost again.
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
