// SPDX-License-Identifier: MIT
/// @file
/// Frames a second, from counts of frames that come at any time: with an interrupt, or a STATUS.
#pragma once

#include <chrono>
#include <cstdint>
#include <optional>

namespace raymarch::daemon
{

/// Over the last one to two seconds where counts come often, else since the count before the last.
class FrameRate
{
  public:
    using Clock = std::chrono::steady_clock;

    explicit FrameRate(std::uint32_t frames, Clock::time_point now = Clock::now()) noexcept
        : from_{frames, now}
        , middle_{frames, now}
        , last_{frames, now}
    {}

    /// FRAMES as it is now. Fewer than before: the accelerator was reset, and it begins anew.
    void sample(std::uint32_t frames, Clock::time_point now = Clock::now()) noexcept
    {
        if (frames < last_.frames)
            from_ = middle_ = {frames, now};
        if (now - middle_.time >= window) {
            from_ = middle_;
            middle_ = {frames, now};
        }
        last_ = {frames, now};
    }

    /// Tenths of a frame a second; nothing before time has passed.
    [[nodiscard]] std::optional<std::uint64_t> tenths_per_second() const noexcept
    {
        using std::chrono::milliseconds;
        const auto elapsed = std::chrono::duration_cast<milliseconds>(last_.time - from_.time);
        if (elapsed.count() <= 0)
            return std::nullopt;
        return std::uint64_t{last_.frames - from_.frames} * 10'000 /
               static_cast<std::uint64_t>(elapsed.count());
    }

  private:
    static constexpr std::chrono::seconds window{1};
    struct Count
    {
        std::uint32_t frames;
        Clock::time_point time;
    };
    Count from_;
    Count middle_; ///< the next from_
    Count last_;
};

} // namespace raymarch::daemon
