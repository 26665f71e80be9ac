// SPDX-License-Identifier: MIT
/// @file
/// Turns Ctrl-C into a stop request, so that temporary files are removed.
#pragma once

#include <csignal>

#include <atomic>
#include <stop_token>
#include <thread>

namespace raymarch::cli
{

/// While it exists, SIGINT, SIGTERM and SIGHUP request a stop and do not end the program. Ignored
/// signals stay ignored. Threads must be started after it.
class Interruption
{
  public:
    Interruption();
    Interruption(const Interruption&) = delete;
    Interruption& operator=(const Interruption&) = delete;
    ~Interruption();

    [[nodiscard]] std::stop_token token() const { return stop_.get_token(); }
    /// Returns the exit status that a shell gives for the signal, 128 plus its number, or 0.
    [[nodiscard]] int status() const noexcept { return status_; }

  private:
    sigset_t signals_{};
    sigset_t mask_before_{};
    std::stop_source stop_;
    std::atomic<int> status_ = 0;
    std::jthread waiting_;
};

} // namespace raymarch::cli
