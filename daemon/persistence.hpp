// SPDX-License-Identifier: MIT
/// @file
/// The states that outlive the service: what each accelerator had last, and what SAVE put aside.
#pragma once

#include "daemon/controller.hpp"
#include "daemon/event_loop.hpp"
#include "daemon/state_store.hpp"

#include <optional>
#include <string>

namespace raymarch::daemon
{

class Persistence final : public Storage
{
  public:
    /// `path` of the state file; empty: nothing is kept. Borrows the loop.
    Persistence(const std::string& path, EventLoop& loop);

    /// Reads the file, at the start.
    void read();
    /// Writes what waits, at the end.
    void flush();

    // Storage
    void changed(const Accelerator& accelerator, const State& state) override;
    [[nodiscard]] bool save(const Accelerator& accelerator, const State& state) override;
    [[nodiscard]] std::optional<State> load(const Accelerator& accelerator) override;
    [[nodiscard]] std::optional<State> last(const Accelerator& accelerator) override;

  private:
    void persist();

    std::optional<StateStore> store_;
    PersistedStates persisted_;
    Source persist_timer_;
    bool persist_waits_ = false;
};

} // namespace raymarch::daemon
