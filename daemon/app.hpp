// SPDX-License-Identifier: MIT
/// @file
/// The composition root: opens what the configuration names, owns everything, and by the order of
/// its members says what outlives what.
#pragma once

#include "daemon/config.hpp"
#include "daemon/control_socket.hpp"
#include "daemon/controller.hpp"
#include "daemon/event_loop.hpp"
#include "daemon/hardware.hpp"
#include "daemon/panel.hpp"
#include "daemon/serial_host.hpp"
#include "daemon/state_store.hpp"
#include "daemon/turns.hpp"
#include "daemon/wake_up.hpp"

#include <chrono>
#include <functional>
#include <list>
#include <optional>

namespace raymarch::daemon
{

/// Reads the configuration again, for SIGHUP.
using Reload = std::function<Result<Config>()>;

class App final : public StatusSource
{
  public:
    App(Config config, Reload reload, EventLoop& loop);
    App(const App&) = delete;
    App& operator=(const App&) = delete;
    ~App() override;

    /// Runs until SIGTERM or SIGINT; those and SIGHUP must be blocked. Errors: the event loop's.
    [[nodiscard]] Result<void> run();
    /// After run(): whether nothing is drawn any more. A picture can take seconds that nobody has,
    /// so a process in which something is still drawn had better end without the destructors.
    [[nodiscard]] bool drawing_has_ended() const noexcept { return drawing_has_ended_; }

    // StatusSource
    void write_status(protocol::StatusValues& status) override;

  private:
    void animate();
    void reload_config();

    EventLoop& loop_;
    Config config_;
    Reload reload_;
    const std::chrono::steady_clock::time_point started_ = std::chrono::steady_clock::now();

    WakeUp stored_;    ///< when the disk has answered
    StateStore store_; ///< borrows stored_

    Source animate_timer_;
    unsigned animate_rate_ = 0; ///< steps a second

    Hardware hardware_;
    Controller controller_; ///< borrows hardware_, store_ and, as StatusSource, the App

    std::optional<Panel> panel_; ///< borrows controller_ and hardware_

    Turns turns_;
    std::optional<SerialHost> serial_;     ///< borrows controller_ and turns_
    std::optional<ControlSocket> control_; ///< the same

    std::list<Source> signals_;
    bool drawing_has_ended_ = true;
};

} // namespace raymarch::daemon
