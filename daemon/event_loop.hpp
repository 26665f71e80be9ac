// SPDX-License-Identifier: MIT
/// @file
/// sd-event with owners: a source lives as long as the handle that add_… returned.
#pragma once

#include "base/result.hpp"

#include <sys/inotify.h>
#include <systemd/sd-event.h>

#include <chrono>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <utility>

namespace raymarch::daemon
{

/// One event source with its handler; removing it is destroying it. One that could not be added
/// (EventLoop::take_problem() says why) is there all the same, and nothing ever comes from it.
class EventSource
{
  public:
    EventSource(const EventSource&) = delete;
    EventSource& operator=(const EventSource&) = delete;
    ~EventSource();

    /// For timers: fires once, `delay` from now. A timer that is armed again forgets the earlier
    /// time.
    void arm(std::chrono::milliseconds delay) noexcept;
    /// For descriptors: which epoll events to wait for from now on. An edge-triggered source that
    /// is told the same events again reports once more what is ready.
    void watch(std::uint32_t events) noexcept;

  private:
    friend class EventLoop;
    EventSource() = default;
    sd_event_source* source_ = nullptr;
    std::function<void(std::uint32_t)> handler_;
    std::function<void(const inotify_event&)> on_change_; ///< in place of handler_, of inotify
};
using Source = std::unique_ptr<EventSource>;

/// The one loop of the service. Handlers run one after the other, on the thread that runs the loop.
class EventLoop
{
  public:
    /// Errors: Unavailable.
    [[nodiscard]] static Result<EventLoop> open();
    EventLoop(EventLoop&& other) noexcept
        : event_(std::exchange(other.event_, nullptr))
        , problem_(std::exchange(other.problem_, std::nullopt))
    {}
    EventLoop(const EventLoop&) = delete;
    EventLoop& operator=(const EventLoop&) = delete;
    EventLoop& operator=(EventLoop&&) = delete;
    ~EventLoop();

    /// Calls `handler` with the epoll events that came. `fd` may come straight from a call that
    /// made none: then errno tells what the problem is.
    [[nodiscard]] Source add_io(int fd, std::uint32_t events,
                                std::function<void(std::uint32_t)> handler);
    /// A timer that waits to be armed.
    [[nodiscard]] Source add_timer(std::function<void()> handler);
    /// Calls `handler` once, after what the loop has found ready already.
    [[nodiscard]] Source add_call(std::function<void()> handler);
    /// The signal must be blocked in every thread.
    [[nodiscard]] Source add_signal(int signal, std::function<void()> handler);

    /// Changes in a folder, or of a file, told by inotify; `mask` as inotify_add_watch() takes it.
    /// The handler must not destroy this source.
    [[nodiscard]] Source add_inotify(const char* folder, std::uint32_t mask,
                                     std::function<void(const inotify_event&)> handler);

    /// The first source since the last call that could not be added: no descriptor, no memory or no
    /// watch is left, or there is no such folder. Nothing when all were. Kind: Unavailable.
    [[nodiscard]] std::optional<Error> take_problem() noexcept
    {
        return std::exchange(problem_, std::nullopt);
    }

    /// Feeds systemd's watchdog where there is one; says whether there is.
    bool feed_watchdog() noexcept;

    /// Until quit(). Errors: InputOutput when the loop itself fails, or a handler runs out of
    /// memory or threads.
    [[nodiscard]] Result<void> run();
    void quit() noexcept;

  private:
    explicit EventLoop(sd_event* event) noexcept : event_(event) {}
    /// The source, or one without its handler where sd-event refused it.
    [[nodiscard]] Source added(Source source, const char* what, int result);

    sd_event* event_;
    std::optional<Error> problem_;
};

} // namespace raymarch::daemon
