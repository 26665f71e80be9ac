// SPDX-License-Identifier: MIT
/// @file
/// Computes frames per second from samples of FRAMES, which may come at any time.
#pragma once

#include <chrono>
#include <cstdint>
#include <optional>

namespace raymarch::daemon
{

/// If samples come often, the rate is over the last one to two seconds, else since the sample
/// before the last.
class FrameRate
{
  public:
    using Clock = std::chrono::steady_clock;

    explicit FrameRate(std::uint32_t frames, Clock::time_point now = Clock::now()) noexcept
        : from_{frames, now}
        , middle_{frames, now}
        , last_{frames, now}
    {}

    /// If FRAMES has become smaller, the accelerator was reset, and the measurement starts again.
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

    /// Returns tenths of a frame per second, or nothing before any time has passed.
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
