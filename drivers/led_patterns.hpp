// SPDX-License-Identifier: MIT
/// @file
/// The patterns of LEDs: a heartbeat, and a blink for each event.
#pragma once

#include <chrono>
#include <cstdint>

namespace raymarch::drivers
{

/// Returns whether the LED is lit at `time`. It beats twice a second.
[[nodiscard]] constexpr bool heartbeat(std::chrono::milliseconds time) noexcept
{
    const auto phase = time.count() % 1000;
    return phase < 100 || (phase >= 200 && phase < 300);
}

/// Lights an LED from one sample to the next if a count has changed. The LED is then dark for at
/// least one sample, so that a stream of events flickers.
class Blinker
{
  public:
    /// Returns whether the LED is lit until the next sample.
    [[nodiscard]] bool sample(std::uint64_t count) noexcept
    {
        lit_ = !lit_ && count != seen_;
        if (lit_)
            seen_ = count;
        return lit_;
    }

  private:
    std::uint64_t seen_ = 0;
    bool lit_ = false;
};

} // namespace raymarch::drivers
