// SPDX-License-Identifier: MIT
/// @file
/// The composition root: opens what the configuration names, owns everything, and by the order of
/// its members says what outlives what.
#pragma once

#include "daemon/back_off.hpp"
#include "daemon/config.hpp"
#include "daemon/controller.hpp"
#include "daemon/endpoint.hpp"
#include "daemon/event_loop.hpp"
#include "daemon/hardware.hpp"
#include "daemon/panel.hpp"
#include "daemon/state_store.hpp"
#include "drivers/unix_socket.hpp"

#include <chrono>
#include <functional>
#include <list>
#include <optional>
#include <string>

namespace raymarch::daemon
{

/// Reads the configuration again, for SIGHUP.
using Reload = std::function<Result<Config>()>;

class App final : public Storage, public StatusSource
{
  public:
    App(Config config, Reload reload, EventLoop& loop);
    App(const App&) = delete;
    App& operator=(const App&) = delete;
    ~App() override;

    /// Runs until SIGTERM or SIGINT; those and SIGHUP must be blocked. Errors: the event loop's.
    [[nodiscard]] Result<void> run();

    // Storage
    void changed(const Accelerator& accelerator, const State& state) override;
    [[nodiscard]] bool save(const Accelerator& accelerator, const State& state) override;
    [[nodiscard]] std::optional<State> load(const Accelerator& accelerator) override;
    [[nodiscard]] std::optional<State> last(const Accelerator& accelerator) override;

    // StatusSource
    void write_status(protocol::ReplyWriter& reply) override;

  private:
    void restore_state();
    void open_serial();
    void open_control();
    void accept_client();
    void persist();
    void animate();
    void reload_config();
    void log_once(std::string& last, const Error& error, const char* what);

    EventLoop& loop_;
    Config config_;
    Reload reload_;
    const std::chrono::steady_clock::time_point started_ = std::chrono::steady_clock::now();

    std::optional<StateStore> store_;
    PersistedStates persisted_;
    Source persist_timer_;
    bool persist_waits_ = false;

    Source animate_timer_;
    unsigned animate_rate_ = 0; ///< steps a second

    Hardware hardware_;
    Controller controller_; ///< borrows hardware_ and, as Storage and StatusSource, the App

    Panel panel_; ///< borrows controller_ and hardware_

    std::optional<Endpoint> serial_;
    std::uint64_t dropped_before_ = 0; ///< by connections that are gone
    std::string serial_problem_;
    BackOff serial_back_off_;
    Source retry_serial_;

    std::optional<drivers::SocketListener> listener_;
    std::string control_problem_;
    BackOff control_back_off_;
    Source retry_control_;
    Source accept_;
    std::list<Endpoint> clients_;

    std::list<Source> signals_;
};

} // namespace raymarch::daemon
