// SPDX-License-Identifier: MIT
#include "daemon/turns.hpp"

#include <time.h>

#include <algorithm>
#include <utility>

namespace raymarch::daemon
{
namespace
{

/// Returns the processor time of this thread. The time of other programs does not count.
std::chrono::nanoseconds processor_time() noexcept
{
    timespec time = {};
    ::clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
    return std::chrono::seconds(time.tv_sec) + std::chrono::nanoseconds(time.tv_nsec);
}

} // namespace

Turn::Turn(Turns& turns, Rank rank, std::function<bool(const TurnIsOver&)> take)
    : turns_(turns)
    , rank_(rank)
    , take_(std::move(take))
{}

Turn::~Turn()
{
    std::erase(turns_.waiting_, this);
    if (turns_.running_ == this)
        turns_.running_ = nullptr;
}

void Turn::ready()
{
    if (waits_ || turns_.running_ == this)
        return;
    if (rank_ == Rank::First && turns_.waiting_.empty() && turns_.running_ == nullptr)
        return turns_.run(*this); // no other host waits
    used_ = std::max(used_, turns_.used_);
    waits_ = true;
    turns_.waiting_.push_back(this);
    turns_.run_soon();
}

Turn& Turns::next() const
{
    const auto goes_first = [this](const Turn* turn) {
        return turn->rank_ == Rank::First && turn != last_;
    };
    const auto first = std::ranges::find_if(waiting_, goes_first);
    if (first != waiting_.end())
        return **first;
    return **std::ranges::min_element(waiting_, {}, &Turn::used_);
}

void Turns::run_next()
{
    soon_ = false;
    if (waiting_.empty()) // the host that waited has left
        return;
    Turn& turn = next();
    std::erase(waiting_, &turn);
    turn.waits_ = false;
    run(turn);
    if (!waiting_.empty())
        run_soon();
}

void Turns::run(Turn& turn)
{
    using Clock = std::chrono::steady_clock;
    const auto processor_before = processor_time();
    if (turn.rank_ == Rank::Equal) // the serial port may get more than an equal share
        used_ = std::max(used_, turn.used_);
    last_ = &turn;
    running_ = &turn;
    const bool more = turn.take_([end = Clock::now() + length_] { return Clock::now() >= end; });
    if (std::exchange(running_, nullptr) == nullptr)
        return;
    turn.used_ += processor_time() - processor_before;
    if (more) {
        turn.waits_ = true;
        waiting_.push_back(&turn);
        run_soon();
    }
}

/// The turn starts after all events that are already ready, so that all hosts with work are known.
void Turns::run_soon()
{
    if (std::exchange(soon_, true))
        return;
    call_ = (call_ + 1) % calls_.size();
    calls_[call_] = loop_.add_call([this] { run_next(); });
}

} // namespace raymarch::daemon
