// SPDX-License-Identifier: MIT
/// @file
/// Keeps the states over a restart: what each accelerator had last, and what SAVE put aside.
///
/// An SD card can take seconds to write a file, and longer than a serial port's buffer lasts. So a
/// thread of its own reads and writes, and the event loop never waits for it.
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
    /// `path` names the state file; empty: nothing is kept. `on_stored` is called on another thread
    /// each time that a StoredState has got its value.
    StateStore(std::string path, std::function<void()> on_stored);
    StateStore(const StateStore&) = delete;
    StateStore& operator=(const StateStore&) = delete;
    ~StateStore() override { finish(); }
    /// Writes what waits to be written, and ends the worker. Changes that come later are not
    /// written.
    void finish();

    /// Makes this process the one that writes the file. Errors: Unavailable when another process
    /// is. A file system without locks is no error.
    [[nodiscard]] Result<void> lock();

    /// Reads the file, at the start. A file that cannot be read, or not understood, is told of, and
    /// kept under another name as soon as there is something to write.
    void read();

    // Storage. A changed state is written two seconds later, with what has changed meanwhile; a
    // write that fails is logged once and tried again every ten seconds.
    void changed(const Accelerator& accelerator, const State& state) override;
    /// What stands in the file already is not written again.
    [[nodiscard]] StoredState save(const Accelerator& accelerator, const State& state) override;
    [[nodiscard]] StoredState load(const Accelerator& accelerator) override;
    [[nodiscard]] std::optional<State> last(const Accelerator& accelerator) override;

  private:
    using Clock = std::chrono::steady_clock;
    struct Job
    {
        const Accelerator* accelerator;
        std::optional<State> saved; ///< what to put aside; nothing: LOAD
        std::promise<std::optional<State>> answer;
    };

    [[nodiscard]] StoredState add(Job job);
    void work(const std::stop_token& stop);
    void do_jobs(std::unique_lock<std::mutex>& lock);
    // On the worker alone.
    void answer(std::vector<Job>& jobs, bool written);
    [[nodiscard]] bool write(const PersistedStates& states);
    [[nodiscard]] Result<void> replace(const PersistedStates& states);
    [[nodiscard]] Result<void> make_way(const std::string& text);

    const std::string path_;
    std::optional<drivers::LockFile> lock_;
    const std::function<void()> on_stored_;

    bool failing_ = false;    ///< the worker's; logged once
    bool unreadable_ = false; ///< what stood in the file at the start could not be read

    std::mutex mutex_; ///< guards what follows
    std::condition_variable_any wake_;
    PersistedStates states_;
    std::optional<Clock::time_point> due_; ///< when changes are to be written; none: there are none
    std::vector<Job> jobs_;
    std::jthread worker_; ///< last: it uses all of the above
};

} // namespace raymarch::daemon
