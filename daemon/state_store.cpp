// SPDX-License-Identifier: MIT
#include "daemon/state_store.hpp"

#include "base/log.hpp"
#include "drivers/atomic_file.hpp"

#include <algorithm>
#include <cerrno>
#include <utility>

namespace raymarch::daemon
{
namespace
{

constexpr std::size_t largest_state_file = 65'536;
constexpr std::chrono::seconds pause_after_change{2};
constexpr std::chrono::seconds pause_after_failure{10};

/// Errors: those of read_file(), and BadData.
Result<PersistedStates> read_states(const std::string& path)
{
    const auto text = drivers::read_file(path, largest_state_file);
    if (!text)
        return fail(text.error());
    auto states = parse_state_file(*text);
    if (!states)
        return fail(plain_error(ErrorKind::BadData, path + ": " + states.error().message));
    return states;
}

} // namespace

StateStore::StateStore(std::string path, std::function<void()> on_stored)
    : path_(std::move(path))
    , on_stored_(std::move(on_stored))
{
    if (!path_.empty())
        worker_ = std::jthread([this](const std::stop_token& stop) { work(stop); });
}

void StateStore::finish()
{
    if (!worker_.joinable())
        return;
    worker_.request_stop();
    worker_.join();
    lock_.reset();
}

Result<void> StateStore::lock()
{
    if (path_.empty())
        return {};
    auto lock = drivers::LockFile::take_for(path_);
    if (lock)
        lock_ = std::move(*lock);
    else if (drivers::held_by_another(lock.error()))
        return fail(lock.error());
    else
        log::info("the state file has no lock: {}", lock.error().message);
    return {};
}

void StateStore::read()
{
    if (path_.empty())
        return;
    auto states = read_states(path_);
    if (states) {
        const std::scoped_lock lock(mutex_);
        states_ = std::move(*states);
    } else if (states.error().number == ENOENT) {
        log::info("there is no stored state: {}", states.error().message);
    } else {
        unreadable_ = true;
        log::warning("starting from the defaults: {}; the file will be renamed",
                     states.error().message);
    }
}

void StateStore::changed(const Accelerator& accelerator, const State& state)
{
    const std::scoped_lock lock(mutex_);
    states_.of(accelerator).last = state;
    if (due_ || path_.empty())
        return;
    due_ = Clock::now() + pause_after_change;
    wake_.notify_one();
}

StoredState StateStore::save(const Accelerator& accelerator, const State& state)
{
    return add({.accelerator = &accelerator, .saved = state, .answer = {}});
}

StoredState StateStore::load(const Accelerator& accelerator)
{
    return add({.accelerator = &accelerator, .saved = std::nullopt, .answer = {}});
}

StoredState StateStore::add(Job job)
{
    if (path_.empty())
        return stored_already(std::nullopt);
    const std::scoped_lock lock(mutex_);
    if (job.saved)
        states_.of(*job.accelerator).last = job.saved;
    StoredState answer = job.answer.get_future();
    jobs_.push_back(std::move(job));
    wake_.notify_one();
    return answer;
}

std::optional<protocol::State> StateStore::last(const Accelerator& accelerator)
{
    const std::scoped_lock lock(mutex_);
    return states_.of(accelerator).last;
}

void StateStore::work(const std::stop_token& stop)
{
    std::unique_lock lock(mutex_);
    while (!stop.stop_requested()) {
        if (due_)
            wake_.wait_until(lock, stop, *due_, [this] { return !jobs_.empty(); });
        else
            wake_.wait(lock, stop, [this] { return !jobs_.empty() || due_; });
        if (!jobs_.empty() || (due_ && Clock::now() >= *due_))
            do_jobs(lock);
    }
    if (!jobs_.empty() || due_)
        do_jobs(lock);
}

/// Does all waiting jobs with one write, so that several SAVEs wait for the disk once.
void StateStore::do_jobs(std::unique_lock<std::mutex>& lock)
{
    std::vector<Job> jobs = std::exchange(jobs_, {});
    const bool changes = std::exchange(due_, std::nullopt).has_value();
    PersistedStates states = states_;
    bool saves = false;
    for (const Job& job : jobs) {
        if (!job.saved)
            continue;
        states.of(*job.accelerator).saved = job.saved;
        saves = true;
    }
    lock.unlock();
    const bool written = (!changes && !saves) || write(states);
    lock.lock();
    if (!written && changes && !due_)
        due_ = Clock::now() + pause_after_failure; // the disk may be full or removed
    for (const Job& job : jobs)
        if (written && job.saved)
            states_.of(*job.accelerator).saved = job.saved;
    lock.unlock();
    answer(jobs, written);
    lock.lock();
}

void StateStore::answer(std::vector<Job>& jobs, bool written)
{
    std::optional<PersistedStates> file; // read if a LOAD needs it
    for (Job& job : jobs) {
        if (job.saved) {
            job.answer.set_value(written ? job.saved : std::nullopt);
            continue;
        }
        if (!file) {
            auto states = read_states(path_);
            file = states ? std::move(*states) : PersistedStates();
        }
        const PersistedState& state = file->of(*job.accelerator);
        job.answer.set_value(state.saved ? state.saved : state.last);
    }
    if (file) { // the user may have restored an older file
        const std::scoped_lock lock(mutex_);
        for (std::size_t i = 0; i < file->states.size(); ++i)
            if (file->states[i].saved)
                states_.states[i].saved = file->states[i].saved;
    }
    if (!jobs.empty() && on_stored_)
        on_stored_();
}

bool StateStore::write(const PersistedStates& states)
{
    const auto result = replace(states);
    if (!result && !failing_)
        log::warning("the state is not kept: {}", result.error().message);
    failing_ = !result;
    return result.has_value();
}

Result<void> StateStore::replace(const PersistedStates& states)
{
    const std::string text = format_state_file(states);
    if (const auto there = drivers::read_file(path_, largest_state_file); there && *there == text) {
        unreadable_ = false;
        return {};
    } else if (there || there.error().number != ENOENT) {
        if (auto renamed = rename_unreadable(there ? *there : std::string()); !renamed)
            return renamed;
    }
    if (auto written =
            drivers::replace_file(path_, drivers::as_bytes(text), drivers::Durability::Durable);
        !written)
        return written;
    unreadable_ = false;
    const auto held = drivers::read_file(path_, largest_state_file);
    if (!held)
        return fail(held.error());
    if (*held != text)
        return fail(
            plain_error(ErrorKind::InputOutput, path_ + " does not hold what was written to it"));
    return {};
}

/// Renames a file that this version cannot read, so that it is not overwritten.
Result<void> StateStore::rename_unreadable(const std::string& text)
{
    if (!unreadable_ && parse_state_file(text))
        return {};
    const auto kept = drivers::set_aside(path_);
    if (!kept)
        return fail(kept.error());
    log::warning("{} is not a state that this version can read; it is renamed to {}", path_, *kept);
    return {};
}

} // namespace raymarch::daemon
