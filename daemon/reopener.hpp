// SPDX-License-Identifier: MIT
/// @file
/// Opens something that is missing again and again, with a back-off, and logs each problem once.
#pragma once

#include "base/log.hpp"
#include "base/result.hpp"
#include "daemon/back_off.hpp"
#include "daemon/event_loop.hpp"

#include <chrono>
#include <functional>
#include <set>
#include <string>
#include <string_view>

namespace raymarch::daemon
{

/// The usual end of a log line about a problem.
inline constexpr std::string_view tried_again = "it will be tried again";

class Reopener
{
  public:
    using Now = std::function<BackOff::Clock::time_point()>;

    /// A problem is logged as `what: problem; outlook`. The loop calls `retry` when it is time for
    /// the next attempt; it must not destroy the Reopener.
    Reopener(EventLoop& loop, std::string_view what, std::function<void()> retry,
             std::string_view outlook = tried_again, Now now = BackOff::Clock::now);

    /// The attempt failed: logs a new problem, and tries again later.
    void missing(const Error& problem);
    /// The attempt succeeded.
    void found();
    /// Tells that it has gone away: opens it again later.
    void lost();

    // The following functions are for several things of which some may be missing.

    /// Logs the problems that the last call did not have.
    void log_new(std::set<std::string> problems, log::Level level = log::Level::Warning,
                 std::string_view outlook = tried_again);
    void some_found() { back_off_.opened(now_()); }
    void some_lost() { back_off_.lost(now_()); }
    void retry_later();
    void retry_now() { timer_->arm({}); }
    /// Tries now, and starts the back-off again.
    void start_again();

    /// Returns the last delay of retry_later().
    [[nodiscard]] std::chrono::milliseconds wait() const noexcept { return wait_; }

  private:
    const std::string_view what_;
    const std::string_view outlook_;
    const Now now_;
    BackOff back_off_;
    std::chrono::milliseconds wait_{};
    std::set<std::string> logged_; ///< the problems of the last attempt
    Source timer_;
};

} // namespace raymarch::daemon
