// SPDX-License-Identifier: MIT
/// @file
/// Makes Ctrl-C visible to poll(), so that a wait ends and the terminal can be restored.
#pragma once

#include "base/unique_fd.hpp"

#include <csignal>

namespace raymarch::cli
{

/// While it exists, SIGINT, SIGTERM and SIGHUP do not end the program but make `fd()` readable.
/// Ignored signals stay ignored. A write to a closed pipe returns EPIPE and raises no signal. The
/// program must have only one thread when the object is made.
class StopSignals
{
  public:
    StopSignals();
    StopSignals(const StopSignals&) = delete;
    StopSignals& operator=(const StopSignals&) = delete;
    ~StopSignals();

    [[nodiscard]] int fd() const noexcept { return fd_.get(); }

    /// Takes the signal that came. Returns 0 if there is none.
    [[nodiscard]] int take() const noexcept;

  private:
    sigset_t mask_before_{};
    struct sigaction pipe_before_ = {};
    UniqueFd fd_;
};

/// The exit status for a signal is 128 plus its number, as in a shell.
inline constexpr int status_of_signal = 128;

} // namespace raymarch::cli
