// SPDX-License-Identifier: MIT
/// @file
/// Notices when somebody removes or replaces what the service has made in a folder: the link to the
/// pseudo-terminal, or the control socket.
#pragma once

#include "daemon/event_loop.hpp"

#include <functional>
#include <string>

namespace raymarch::daemon
{

class PlaceWatch
{
  public:
    /// `look` is called from a timer of the loop, so it may destroy what it likes but this object.
    PlaceWatch(EventLoop& loop, std::function<void()> look);

    /// Watches the folder of `path`, in place of what was watched before. `look` is called soon,
    /// and whenever the folder itself, or its entry of that name, changes.
    void watch(const std::string& path);

  private:
    EventLoop& loop_;
    Source look_;
    Source watch_;
};

} // namespace raymarch::daemon
