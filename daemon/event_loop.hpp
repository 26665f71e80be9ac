// SPDX-License-Identifier: MIT
/// @file
/// Wraps sd-event: a source lives as long as the handle that add_… returned.
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

/// One event source with its handler. Its destructor removes it from the loop. A source that could
/// not be added never calls its handler; EventLoop::take_problem() tells why.
class EventSource
{
  public:
    EventSource(const EventSource&) = delete;
    EventSource& operator=(const EventSource&) = delete;
    ~EventSource();

    /// For timers: fires once, `delay` from now. A second call replaces the first.
    void arm(std::chrono::milliseconds delay) noexcept;
    /// For descriptors: sets the epoll events to wait for. An edge-triggered source then reports
    /// again what is ready, even if the events are the same.
    void watch(std::uint32_t events) noexcept;

  private:
    friend class EventLoop;
    EventSource() = default;
    sd_event_source* source_ = nullptr;
    std::function<void(std::uint32_t)> handler_;
    std::function<void(const inotify_event&)> on_change_; ///< inotify uses this handler
};
using Source = std::unique_ptr<EventSource>;

/// The event loop of the service. Handlers run one after the other, on the thread that runs it.
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

    /// Calls `handler` with the epoll events that came. `fd` may be the -1 of a failed call whose
    /// errno is still set.
    [[nodiscard]] Source add_io(int fd, std::uint32_t events,
                                std::function<void(std::uint32_t)> handler);
    /// Adds a timer that is not armed.
    [[nodiscard]] Source add_timer(std::function<void()> handler);
    /// Calls `handler` once, after the events that are already ready.
    [[nodiscard]] Source add_call(std::function<void()> handler);
    /// The signal must be blocked in every thread.
    [[nodiscard]] Source add_signal(int signal, std::function<void()> handler);

    /// Watches a folder or a file with inotify; `mask` is that of inotify_add_watch(). The handler
    /// must not destroy this source.
    [[nodiscard]] Source add_inotify(const char* folder, std::uint32_t mask,
                                     std::function<void(const inotify_event&)> handler);

    /// Returns the first error of an add_… function since the last call: no descriptor, no memory
    /// or no watch is left, or there is no such folder. Its kind is Unavailable.
    [[nodiscard]] std::optional<Error> take_problem() noexcept
    {
        return std::exchange(problem_, std::nullopt);
    }

    /// Feeds systemd's watchdog. Returns whether there is one.
    bool feed_watchdog() noexcept;

    /// Runs until quit(). Errors: InputOutput if the loop itself fails, or if a handler runs out of
    /// memory or threads.
    [[nodiscard]] Result<void> run();
    void quit() noexcept;

  private:
    explicit EventLoop(sd_event* event) noexcept : event_(event) {}
    /// Keeps the error if sd-event refused the source.
    [[nodiscard]] Source added(Source source, const char* what, int result);

    sd_event* event_;
    std::optional<Error> problem_;
};

} // namespace raymarch::daemon
