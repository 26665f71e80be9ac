// SPDX-License-Identifier: MIT
#include "daemon/controller.hpp"

#include "protocol/assignments.hpp"
#include "protocol/groups.hpp"
#include "protocol/registers.hpp"
#include "protocol/views.hpp"

#include <variant>

namespace raymarch::daemon
{
namespace
{

using namespace protocol; // NOLINT(google-build-using-namespace): most names here are its own

/// Whether the board took the words; it may write them later.
bool taken(Applied applied) noexcept
{
    return applied == Applied::Written || applied == Applied::Deferred;
}

} // namespace

Controller::Controller(const Accelerator& accelerator, Policy policy, Board& board,
                       Storage& storage, StatusSource& status, std::uint64_t random_seed)
    : accelerator_(&accelerator)
    , policy_(policy)
    , board_(board)
    , storage_(storage)
    , status_(status)
    , random_(random_seed)
    , state_(initial_state(accelerator))
    , words_(pack(accelerator, state_))
{}

std::string_view Controller::execute(const Line& line, SessionSettings& session, Unfinished& rest,
                                     const TurnIsOver& turn_is_over)
{
    const TypedRequest request =
        parse(line, {*accelerator_, state_, read_}, policy_.require_checksum);
    if (const auto* const silence = std::get_if<Silence>(&request.what)) {
        echoed_ += *silence == Silence::Reply ? 1 : 0;
        return {};
    }
    reply_.begin(request.checksummed);
    const Outcome fault = dispatch(request, {session, rest, turn_is_over});
    if (rest.any()) {
        rest.checksummed_ = request.checksummed;
        return {};
    }
    return settle(fault, request.effect != Effect::Reads, request.checksummed);
}

std::string_view Controller::settle(const Outcome& fault, bool writes, bool checksummed)
{
    if (writes)
        last_refused_ = fault.has_value();
    if (fault) {
        ++rejected_[static_cast<std::size_t>(fault->code)];
        reply_.begin(checksummed); // without what was written before the fault was found
        write_fault(reply_, *accelerator_, *fault);
    }
    const bool wanted = policy_.replies == Replies::All ||
                        (policy_.replies == Replies::Errors && fault.has_value());
    return wanted ? reply_.text() : std::string_view();
}

bool Controller::restore(const State& state)
{
    return write_state(state, words_, Source::Storage).has_value();
}

void Controller::board_is_back(const Accelerator& accelerator)
{
    if (&accelerator != accelerator_)
        recall(accelerator);
    static_cast<void>(restore(state_)); // the board itself reports what it does not take
}

Controller::Outcome Controller::dispatch(const TypedRequest& request, const Call& call)
{
    if (locked_ && request.effect == Effect::Writes)
        return Fault{.code = ErrorCode::Locked};
    if (const auto* const fault = std::get_if<Fault>(&request.what))
        return *fault;
    if (const auto* const frame = std::get_if<Frame>(&request.what))
        return apply(*frame->state, words_);
    return std::visit([&](const auto& command) { return run(command, call); },
                      std::get<AnyCommand<commands>>(request.what));
}

Controller::Outcome Controller::apply(const State& state, const Words& before)
{
    const bool orthonormal =
        policy_.basis_check == BasisCheck::Off || basis_is_orthonormal(*accelerator_, state);
    if (!orthonormal && policy_.basis_check == BasisCheck::Reject)
        return Fault{.code = ErrorCode::Basis};
    const auto changed = write_state(state, before);
    if (!changed)
        return Fault{.code = ErrorCode::Hardware};
    ++applied_;
    reply_ << "OK seq=" << applied_ << " changed=" << *changed;
    if (!orthonormal)
        reply_ << " warn=" << error_row(ErrorCode::Basis).name;
    reply_.end_line();
    return std::nullopt;
}

std::optional<std::uint64_t> Controller::write_state(const State& state, const Words& before,
                                                     Source source)
{
    const Words words = pack(*accelerator_, state);
    const bool done = taken(board_.apply(words));
    if (!done && source == Source::Change)
        return std::nullopt;
    std::uint64_t changed = 0;
    for (std::size_t i = 0; i < accelerator_->word_count; ++i)
        changed += words[i] != before[i] ? 1 : 0;
    if (!(state == state_)) {
        if (source == Source::Change)
            storage_.changed(*accelerator_, state);
        ++changes_;
        state_ = state;
    }
    words_ = words;
    return done ? std::optional(changed) : std::nullopt;
}

void Controller::recall(const Accelerator& accelerator)
{
    accelerator_ = &accelerator;
    preset_.reset();
    ++changes_;
    state_ = storage_.last(accelerator).value_or(initial_state(accelerator));
    words_ = pack(accelerator, state_);
}

void Controller::animate()
{
    if (locked_)
        return;
    State state = state_;
    movement_.animate(*accelerator_, state);
    if (!(state == state_))
        write_state(state, words_); // the next step begins where the last one ended
}

void Controller::to_defaults()
{
    State state = state_;
    reset(*accelerator_, {}, state);
    if (write_state(state, words_))
        preset_.reset();
}

void Controller::to_next_scene()
{
    std::optional<std::size_t> preset = preset_;
    if (write_state(next_scene(*accelerator_, state_, preset), words_))
        preset_ = preset;
}

void Controller::orbit(Side side)
{
    State state = state_;
    movement_.orbit(*accelerator_, state, side);
    if (!(state == state_))
        write_state(state, words_);
}

Controller::Outcome Controller::ok()
{
    reply_ << "OK";
    reply_.end_line();
    return std::nullopt;
}

} // namespace raymarch::daemon
