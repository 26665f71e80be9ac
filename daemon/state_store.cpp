// SPDX-License-Identifier: MIT
#include "daemon/state_store.hpp"

#include "base/log.hpp"
#include "drivers/atomic_file.hpp"

#include <chrono>
#include <utility>

namespace raymarch::daemon
{
namespace
{

constexpr std::size_t largest_state_file = 65'536;
constexpr std::chrono::seconds pause_after_failure{10};

} // namespace

StateStore::StateStore(std::string path)
    : path_(std::move(path))
    , worker_([this](const std::stop_token& stop) { work(stop); })
{}

StateStore::~StateStore()
{
    worker_.request_stop();
}

Result<PersistedStates> StateStore::load() const
{
    auto text = drivers::read_file(path_, largest_state_file);
    if (!text)
        return fail(text.error());
    auto state = parse_state_file(*text);
    if (!state)
        return fail(plain_error(ErrorKind::BadData, path_ + ": " + state.error().message));
    return state;
}

/// The file's lock comes first: what write_now() wrote in between must not be overwritten by what
/// waited before it. What could not be written waits on, unless something newer does.
bool StateStore::write_waiting()
{
    const std::scoped_lock file_lock(file_mutex_);
    std::unique_lock lock(mutex_);
    const std::optional<PersistedStates> state = std::exchange(waiting_, std::nullopt);
    lock.unlock();
    if (!state || write(*state))
        return true;
    lock.lock();
    if (!waiting_)
        waiting_ = state;
    return false;
}

bool StateStore::behind()
{
    const std::scoped_lock lock(mutex_);
    return waiting_.has_value();
}

Result<void> StateStore::write(const PersistedStates& state)
{
    const std::string text = format_state_file(state);
    auto result =
        drivers::replace_file(path_, drivers::as_bytes(text), drivers::Durability::Durable);
    if (!result && !failing_)
        log::warning("the state is not kept: {}", result.error().message);
    failing_ = !result;
    return result;
}

void StateStore::write_later(const PersistedStates& state)
{
    const std::scoped_lock lock(mutex_);
    waiting_ = state;
    wake_.notify_one();
}

Result<void> StateStore::write_now(const PersistedStates& state)
{
    const std::scoped_lock file_lock(file_mutex_);
    std::unique_lock lock(mutex_);
    const std::optional<PersistedStates> older = std::exchange(waiting_, std::nullopt);
    lock.unlock();
    auto result = write(state);
    lock.lock();
    if (!result && !waiting_)
        waiting_ = older; // still better than what is in the file
    return result;
}

void StateStore::work(const std::stop_token& stop)
{
    std::unique_lock lock(mutex_);
    while (wake_.wait(lock, stop, [this] { return waiting_.has_value(); })) {
        lock.unlock();
        const bool written = write_waiting();
        lock.lock();
        if (!written) // the disk may be full, or away: not over and over
            wake_.wait_for(lock, stop, pause_after_failure, [] { return false; });
        if (stop.stop_requested())
            return;
    }
}

} // namespace raymarch::daemon
