// SPDX-License-Identifier: MIT
/// @file
/// Lets another thread call a handler on the event loop.
#pragma once

#include "base/unique_fd.hpp"
#include "daemon/event_loop.hpp"

#include <sys/epoll.h>
#include <sys/eventfd.h>
#include <unistd.h>

#include <cstdint>
#include <functional>
#include <utility>

namespace raymarch::daemon
{

class WakeUp
{
  public:
    WakeUp(EventLoop& loop, std::function<void()> handler)
        : fd_(::eventfd(0, EFD_NONBLOCK | EFD_CLOEXEC))
        , source_(
              loop.add_io(fd_.get(), EPOLLIN, [this, handler = std::move(handler)](std::uint32_t) {
                  std::uint64_t count = 0;
                  [[maybe_unused]] const auto size = ::read(fd_.get(), &count, sizeof count);
                  handler();
              }))
    {}

    WakeUp(const WakeUp&) = delete;
    WakeUp& operator=(const WakeUp&) = delete;

    /// Any thread may call this function. The loop calls the handler once for all calls before
    /// that.
    void notify() const noexcept
    {
        const std::uint64_t one = 1;
        [[maybe_unused]] const auto size = ::write(fd_.get(), &one, sizeof one);
    }

  private:
    UniqueFd fd_;
    Source source_;
};

} // namespace raymarch::daemon
