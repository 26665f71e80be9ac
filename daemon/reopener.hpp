// SPDX-License-Identifier: MIT
/// @file
/// Looks again for something that is missing or has gone away, and logs once why it is not there.
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

/// The usual end of the log line of a problem.
inline constexpr std::string_view tried_again = "it will be tried again";

class Reopener
{
  public:
    using Now = std::function<BackOff::Clock::time_point()>;

    /// A problem is logged as `what: problem; then`. `look` is called, from the loop, when it is
    /// time to look again; it does not destroy the Reopener.
    Reopener(EventLoop& loop, std::string_view what, std::function<void()> look,
             std::string_view then = tried_again, Now now = BackOff::Clock::now);

    /// It is not there: that is logged unless it was the last time too, and it is looked for later.
    void missing(const Error& problem);
    /// It is there.
    void found();
    /// It was there and has gone away: it is looked for later.
    void lost();

    // The parts of the above, for something of which some may be there and some not.

    /// Logs those of the problems that were not there the last time.
    void tell(std::set<std::string> problems, log::Level level = log::Level::Warning,
              std::string_view then = tried_again);
    /// Some of it was found, or lost: the waiting is as if it had been all.
    void some_found() { back_off_.opened(now_()); }
    void some_lost() { back_off_.lost(now_()); }
    void look_later();
    void look_now() { timer_->arm({}); }
    /// There is a reason to look now, and often again.
    void look_anew();

    /// The time that look_later() waits, or waited the last time.
    [[nodiscard]] std::chrono::milliseconds wait() const noexcept { return wait_; }

  private:
    const std::string_view what_;
    const std::string_view then_;
    const Now now_;
    BackOff back_off_;
    std::chrono::milliseconds wait_{};
    std::set<std::string> told_; ///< the problems of the last time
    Source timer_;
};

} // namespace raymarch::daemon
