// SPDX-License-Identifier: MIT
/// @file
/// Waiting for a descriptor, with an end that only a defect reaches.
#pragma once

#include <poll.h>

namespace raymarch::test
{

inline constexpr int patience_ms = 20'000;

/// The events that came, or 0 after `timeout_ms`.
[[nodiscard]] inline int wait_for(int fd, short events, int timeout_ms = patience_ms)
{
    pollfd waiting = {.fd = fd, .events = events, .revents = 0};
    return ::poll(&waiting, 1, timeout_ms) > 0 ? waiting.revents : 0;
}

[[nodiscard]] inline bool readable(int fd, int timeout_ms = patience_ms)
{
    return (wait_for(fd, POLLIN, timeout_ms) & POLLIN) != 0;
}

} // namespace raymarch::test
