// SPDX-License-Identifier: MIT
/// @file
/// Ctrl-C as something that poll() sees, so that a wait ends and everything is put back.
#pragma once

#include "base/unique_fd.hpp"

#include <csignal>

namespace raymarch::cli
{

/// As long as it is there, SIGINT, SIGTERM and SIGHUP do not end the program but make `fd()`
/// readable; those that are ignored stay so. A pipe that nobody reads any longer is an error of the
/// write (EPIPE) and no signal. The program must have one thread when it is made.
class StopSignals
{
  public:
    StopSignals();
    StopSignals(const StopSignals&) = delete;
    StopSignals& operator=(const StopSignals&) = delete;
    ~StopSignals();

    [[nodiscard]] int fd() const noexcept { return fd_.get(); }

    /// The signal that came, which is then forgotten; 0 where none came.
    [[nodiscard]] int take() const noexcept;

  private:
    sigset_t mask_before_{};
    struct sigaction pipe_before_ = {};
    UniqueFd fd_;
};

/// A shell says of a program that a signal ended: 128 and the signal's number.
inline constexpr int status_of_signal = 128;

} // namespace raymarch::cli
