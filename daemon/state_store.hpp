// SPDX-License-Identifier: MIT
/// @file
/// Keeps the last state and the saved state of each accelerator in a file.
///
/// An SD card can take seconds to write a file, and a serial port's buffer would overflow
/// meanwhile. So a worker thread reads and writes the file, and the event loop never waits for it.
#pragma once

#include "base/result.hpp"
#include "daemon/controller.hpp"
#include "daemon/state_file.hpp"
#include "drivers/lock_file.hpp"

#include <chrono>
#include <condition_variable>
#include <functional>
#include <future>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

namespace raymarch::daemon
{

class StateStore final : public Storage
{
  public:
    /// `path` is the state file; without one nothing is kept. The worker thread calls `on_stored`
    /// when StoredStates have got their values.
    StateStore(std::string path, std::function<void()> on_stored);
    StateStore(const StateStore&) = delete;
    StateStore& operator=(const StateStore&) = delete;
    ~StateStore() override { finish(); }
    /// Writes all waiting changes and ends the worker. Later changes are not written.
    void finish();

    /// Locks the file. Errors: Unavailable if another process has the lock. A file system without
    /// locks is not an error.
    [[nodiscard]] Result<void> lock();

    /// Reads the file at the start. A file that cannot be read or parsed is logged, and renamed
    /// before the next write.
    void read();

    /// A changed state is written two seconds later, together with other changes. A failed write is
    /// logged once and tried again every ten seconds.
    void changed(const Accelerator& accelerator, const State& state) override;
    /// The file is not written again if its content is the same.
    [[nodiscard]] StoredState save(const Accelerator& accelerator, const State& state) override;
    [[nodiscard]] StoredState load(const Accelerator& accelerator) override;
    [[nodiscard]] std::optional<State> last(const Accelerator& accelerator) override;

  private:
    using Clock = std::chrono::steady_clock;
    struct Job
    {
        const Accelerator* accelerator;
        std::optional<State> saved; ///< the state to save, or nothing for LOAD
        std::promise<std::optional<State>> answer;
    };

    [[nodiscard]] StoredState add(Job job);
    void work(const std::stop_token& stop);
    void do_jobs(std::unique_lock<std::mutex>& lock);
    // Only the worker calls these functions.
    void answer(std::vector<Job>& jobs, bool written);
    [[nodiscard]] bool write(const PersistedStates& states);
    [[nodiscard]] Result<void> replace(const PersistedStates& states);
    [[nodiscard]] Result<void> rename_unreadable(const std::string& text);

    const std::string path_;
    std::optional<drivers::LockFile> lock_;
    const std::function<void()> on_stored_;

    bool failing_ = false;    ///< the last write failed
    bool unreadable_ = false; ///< the file could not be read at the start

    std::mutex mutex_; ///< guards the following members up to jobs_
    std::condition_variable_any wake_;
    PersistedStates states_;
    std::optional<Clock::time_point> due_; ///< when changes are to be written, if there are any
    std::vector<Job> jobs_;
    std::jthread worker_; ///< declared last: it uses all members above
};

} // namespace raymarch::daemon
