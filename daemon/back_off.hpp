// SPDX-License-Identifier: MIT
/// @file
/// How long to wait before something that is missing is looked for again.
#pragma once

#include <algorithm>
#include <chrono>

namespace raymarch::daemon
{

/// 250 ms at first, twice as long each time, 30 s at most.
class BackOff
{
  public:
    [[nodiscard]] std::chrono::milliseconds next() noexcept
    {
        const auto delay = delay_;
        delay_ = std::min(2 * delay_, std::chrono::milliseconds(30'000));
        return delay;
    }
    void reset() noexcept { delay_ = first; }

  private:
    static constexpr std::chrono::milliseconds first{250};
    std::chrono::milliseconds delay_ = first;
};

} // namespace raymarch::daemon
