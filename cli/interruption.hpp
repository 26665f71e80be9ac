// SPDX-License-Identifier: MIT
/// @file
/// Ctrl-C as a request to stop, so that what is unfinished is cleared away.
#pragma once

#include <csignal>

#include <atomic>
#include <stop_token>
#include <thread>

namespace raymarch::cli
{

/// As long as it is there, SIGINT, SIGTERM and SIGHUP request a stop in place of ending the
/// program; those that are ignored stay so. Threads have to be started after it.
class Interruption
{
  public:
    Interruption();
    Interruption(const Interruption&) = delete;
    Interruption& operator=(const Interruption&) = delete;
    ~Interruption();

    [[nodiscard]] std::stop_token token() const { return stop_.get_token(); }
    /// What a shell says of a program that the signal ended: 128 and its number; 0 without one.
    [[nodiscard]] int status() const noexcept { return status_; }

  private:
    sigset_t signals_{};
    sigset_t mask_before_{};
    std::stop_source stop_;
    std::atomic<int> status_ = 0;
    std::jthread waiting_;
};

} // namespace raymarch::cli
