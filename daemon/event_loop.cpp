// SPDX-License-Identifier: MIT
#include "daemon/event_loop.hpp"

#include <cerrno>
#include <ctime>
#include <new>
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

/// An exception must not pass through sd-event, which is C. It ends the loop instead.
template <typename Handler>
int guarded(sd_event_source* source, Handler handler) noexcept
{
    int number = ENOMEM;
    try {
        handler();
        return 0;
    } catch (const std::system_error& error) { // no thread can be started, for example
        number = error.code().value() > 0 ? error.code().value() : EIO;
    } catch (const std::bad_alloc&) {
    }
    sd_event_exit(sd_event_source_get_event(source), -number);
    return 0;
}

} // namespace

EventSource::~EventSource()
{
    sd_event_source_disable_unref(source_);
}

void EventSource::arm(std::chrono::milliseconds delay) noexcept
{
    if (source_ == nullptr)
        return;
    const auto microseconds = std::chrono::duration_cast<std::chrono::microseconds>(delay).count();
    sd_event_source_set_time_relative(source_, static_cast<std::uint64_t>(microseconds));
    sd_event_source_set_enabled(source_, SD_EVENT_ONESHOT);
}

void EventSource::watch(std::uint32_t events) noexcept
{
    if (source_ != nullptr)
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

Source EventLoop::added(Source source, const char* what, int result)
{
    if (result < 0 && !problem_)
        problem_ = loop_error(ErrorKind::Unavailable, what, result);
    return source;
}

Source EventLoop::add_io(int fd, std::uint32_t events, std::function<void(std::uint32_t)> handler)
{
    const int why = errno; // if `fd` is -1: the error of the call that should have made it
    Source source(new EventSource);
    source->handler_ = std::move(handler);
    const auto call = [](sd_event_source* from, int, std::uint32_t revents, void* self) {
        return guarded(from, [&] { static_cast<EventSource*>(self)->handler_(revents); });
    };
    const int result = fd < 0 && why > 0 ? -why
                                         : sd_event_add_io(event_, &source->source_, fd, events,
                                                           call, source.get());
    return added(std::move(source), "wait for a descriptor", result);
}

Source EventLoop::add_timer(std::function<void()> handler)
{
    Source source(new EventSource);
    source->handler_ = [handler = std::move(handler)](std::uint32_t) { handler(); };
    const auto call = [](sd_event_source* from, std::uint64_t, void* self) {
        return guarded(from, [&] { static_cast<EventSource*>(self)->handler_(0); });
    };
    const int result = sd_event_add_time_relative(event_, &source->source_, CLOCK_MONOTONIC, 0, 1,
                                                  call, source.get());
    if (result >= 0)
        sd_event_source_set_enabled(source->source_, SD_EVENT_OFF);
    return added(std::move(source), "make a timer", result);
}

Source EventLoop::add_call(std::function<void()> handler)
{
    Source source(new EventSource);
    source->handler_ = [handler = std::move(handler)](std::uint32_t) { handler(); };
    const auto call = [](sd_event_source* from, void* self) {
        return guarded(from, [&] { static_cast<EventSource*>(self)->handler_(0); });
    };
    const int result = sd_event_add_defer(event_, &source->source_, call, source.get());
    return added(std::move(source), "call a handler", result);
}

Source EventLoop::add_signal(int signal, std::function<void()> handler)
{
    Source source(new EventSource);
    source->handler_ = [handler = std::move(handler)](std::uint32_t) { handler(); };
    const auto call = [](sd_event_source* from, const signalfd_siginfo*, void* self) {
        return guarded(from, [&] { static_cast<EventSource*>(self)->handler_(0); });
    };
    const int result = sd_event_add_signal(event_, &source->source_, signal, call, source.get());
    return added(std::move(source), "wait for a signal", result);
}

Source EventLoop::add_inotify(const char* folder, std::uint32_t mask,
                              std::function<void(const inotify_event&)> handler)
{
    Source source(new EventSource);
    source->on_change_ = std::move(handler);
    const auto call = [](sd_event_source* from, const inotify_event* event, void* self) {
        return guarded(from, [&] { static_cast<EventSource*>(self)->on_change_(*event); });
    };
    const int result =
        sd_event_add_inotify(event_, &source->source_, folder, mask, call, source.get());
    return added(std::move(source), "watch a folder or file", result);
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
