// SPDX-License-Identifier: MIT
#include "daemon/persistence.hpp"

#include "base/log.hpp"

#include <chrono>

namespace raymarch::daemon
{
namespace
{

/// The state is written at most this often.
constexpr std::chrono::milliseconds persist_interval{2000};

} // namespace

Persistence::Persistence(const std::string& path, EventLoop& loop)
    : persist_timer_(loop.add_timer([this] { persist(); }))
{
    if (!path.empty())
        store_.emplace(path);
}

void Persistence::read()
{
    if (!store_)
        return;
    auto loaded = store_->load();
    if (loaded) {
        persisted_ = *loaded;
    } else if (loaded.error().kind == ErrorKind::Unavailable) {
        log::info("no state from earlier: {}", loaded.error().message);
    } else {
        log::warning("starting from the defaults: {}", loaded.error().message);
    }
}

void Persistence::changed(const Accelerator& accelerator, const State& state)
{
    persisted_.of(accelerator).last = state;
    if (!store_ || persist_waits_)
        return;
    persist_waits_ = true;
    persist_timer_->arm(persist_interval);
}

void Persistence::persist()
{
    persist_waits_ = false;
    if (store_)
        store_->write_later(persisted_);
}

bool Persistence::save(const Accelerator& accelerator, const State& state)
{
    if (!store_)
        return false;
    PersistedStates both = persisted_;
    both.of(accelerator) = {.last = state, .saved = state};
    if (both == persisted_ && !persist_waits_ && !store_->behind() && store_->load())
        return true; // the file holds it
    if (!store_->write_now(both))
        return false;
    persisted_ = both;
    return true;
}

std::optional<protocol::State> Persistence::load(const Accelerator& accelerator)
{
    if (!store_)
        return std::nullopt;
    auto loaded = store_->load();
    if (!loaded)
        return std::nullopt;
    const PersistedState& state = loaded->of(accelerator);
    return state.saved ? state.saved : state.last;
}

std::optional<protocol::State> Persistence::last(const Accelerator& accelerator)
{
    return persisted_.of(accelerator).last;
}

void Persistence::flush()
{
    if (store_ && (persist_waits_ || store_->behind()))
        static_cast<void>(store_->write_now(persisted_)); // a failure has been logged
}

} // namespace raymarch::daemon
