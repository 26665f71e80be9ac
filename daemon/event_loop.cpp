// SPDX-License-Identifier: MIT
#include "daemon/event_loop.hpp"

#include <ctime>
#include <system_error>

namespace raymarch::daemon
{
namespace
{

Error loop_error(ErrorKind kind, const char* what, int result)
{
    return Error{kind, -result,
                 std::string(what) + ": " + std::generic_category().message(-result)};
}

} // namespace

EventSource::~EventSource()
{
    sd_event_source_disable_unref(source_);
}

void EventSource::arm(std::chrono::milliseconds delay) noexcept
{
    const auto microseconds = std::chrono::duration_cast<std::chrono::microseconds>(delay).count();
    sd_event_source_set_time_relative(source_, static_cast<std::uint64_t>(microseconds));
    sd_event_source_set_enabled(source_, SD_EVENT_ONESHOT);
}

void EventSource::watch(std::uint32_t events) noexcept
{
    sd_event_source_set_io_events(source_, events);
}

Result<EventLoop> EventLoop::open()
{
    sd_event* event = nullptr;
    if (const int result = sd_event_new(&event); result < 0)
        return fail(loop_error(ErrorKind::Unavailable, "make an event loop", result));
    return EventLoop(event);
}

EventLoop::~EventLoop()
{
    sd_event_unref(event_);
}

Source EventLoop::add_io(int fd, std::uint32_t events, std::function<void(std::uint32_t)> handler)
{
    Source source(new EventSource);
    source->handler_ = std::move(handler);
    const auto call = [](sd_event_source*, int, std::uint32_t revents, void* self) {
        static_cast<EventSource*>(self)->handler_(revents);
        return 0;
    };
    if (sd_event_add_io(event_, &source->source_, fd, events, call, source.get()) < 0)
        return nullptr;
    return source;
}

Source EventLoop::add_timer(std::function<void()> handler)
{
    Source source(new EventSource);
    source->handler_ = [handler = std::move(handler)](std::uint32_t) { handler(); };
    const auto call = [](sd_event_source*, std::uint64_t, void* self) {
        static_cast<EventSource*>(self)->handler_(0);
        return 0;
    };
    if (sd_event_add_time_relative(event_, &source->source_, CLOCK_MONOTONIC, 0, 1, call,
                                   source.get()) < 0)
        return nullptr;
    sd_event_source_set_enabled(source->source_, SD_EVENT_OFF);
    return source;
}

Source EventLoop::add_call(std::function<void()> handler)
{
    Source source(new EventSource);
    source->handler_ = [handler = std::move(handler)](std::uint32_t) { handler(); };
    const auto call = [](sd_event_source*, void* self) {
        static_cast<EventSource*>(self)->handler_(0);
        return 0;
    };
    if (sd_event_add_defer(event_, &source->source_, call, source.get()) < 0)
        return nullptr;
    return source;
}

Source EventLoop::add_signal(int signal, std::function<void()> handler)
{
    Source source(new EventSource);
    source->handler_ = [handler = std::move(handler)](std::uint32_t) { handler(); };
    const auto call = [](sd_event_source*, const signalfd_siginfo*, void* self) {
        static_cast<EventSource*>(self)->handler_(0);
        return 0;
    };
    if (sd_event_add_signal(event_, &source->source_, signal, call, source.get()) < 0)
        return nullptr;
    return source;
}

Source EventLoop::add_inotify(const char* folder, std::uint32_t mask,
                              std::function<void(const inotify_event&)> handler)
{
    Source source(new EventSource);
    source->on_change_ = std::move(handler);
    const auto call = [](sd_event_source*, const inotify_event* event, void* self) {
        static_cast<EventSource*>(self)->on_change_(*event);
        return 0;
    };
    if (sd_event_add_inotify(event_, &source->source_, folder, mask, call, source.get()) < 0)
        return nullptr;
    return source;
}

bool EventLoop::feed_watchdog() noexcept
{
    return sd_event_set_watchdog(event_, 1) > 0;
}

Result<void> EventLoop::run()
{
    if (const int result = sd_event_loop(event_); result < 0)
        return fail(loop_error(ErrorKind::InputOutput, "event loop", result));
    return {};
}

void EventLoop::quit() noexcept
{
    sd_event_exit(event_, 0);
}

} // namespace raymarch::daemon
