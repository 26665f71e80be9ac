// SPDX-License-Identifier: MIT
/// @file
/// When an LED is lit that beats or blinks.
#pragma once

#include <chrono>
#include <cstdint>

namespace raymarch::drivers
{

/// Two short beats a second, `since` any beginning.
[[nodiscard]] constexpr bool heartbeat(std::chrono::milliseconds since) noexcept
{
    const auto phase = since.count() % 1000;
    return phase < 100 || (phase >= 200 && phase < 300);
}

/// Blinks when a count has moved on: lit from one look to the next, then dark for one at least, so
/// that a stream of events is a flicker and no steady light.
class Blinker
{
  public:
    /// Whether the LED is lit from now to the next look.
    [[nodiscard]] bool look(std::uint64_t count) noexcept
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
