// SPDX-License-Identifier: MIT
/// @file
/// Keeps the state over a restart: the file, and the thread that writes it.
///
/// Reaching the disk can take seconds on an SD card, longer than a serial port's buffer lasts; so a
/// thread of its own writes, and the event loop only hands over what is to be written.
#pragma once

#include "base/result.hpp"
#include "daemon/state_file.hpp"

#include <condition_variable>
#include <cstdint>
#include <mutex>
#include <optional>
#include <string>
#include <thread>

namespace raymarch::daemon
{

class StateStore
{
  public:
    explicit StateStore(std::string path);
    StateStore(const StateStore&) = delete;
    StateStore& operator=(const StateStore&) = delete;
    /// Waits for what is being written; writes nothing more.
    ~StateStore();

    /// What the file holds. Errors: Unavailable (there is none), InputOutput, BadData.
    [[nodiscard]] Result<PersistedStates> load() const;

    /// Hands over; the newest wins. A write that fails is logged once and tried again until it
    /// succeeds or something newer comes.
    void write_later(const PersistedStates& state);
    /// Writes, and waits for it. Errors: InputOutput.
    [[nodiscard]] Result<void> write_now(const PersistedStates& state);

    /// Whether something that was handed over is not in the file yet.
    [[nodiscard]] bool behind();

  private:
    /// With file_mutex_ held.
    [[nodiscard]] Result<void> write(const PersistedStates& state);
    [[nodiscard]] bool write_waiting();
    void work(const std::stop_token& stop);

    const std::string path_;

    std::mutex file_mutex_; ///< one writer at a time
    bool failing_ = false;  ///< guarded by file_mutex_

    std::mutex mutex_; ///< guards waiting_
    std::condition_variable_any wake_;
    std::optional<PersistedStates> waiting_;
    std::jthread worker_; ///< last: it uses all of the above
};

} // namespace raymarch::daemon
