// SPDX-License-Identifier: MIT
#include "daemon/controller.hpp"

#include "protocol/arguments.hpp"
#include "protocol/assignments.hpp"
#include "protocol/views.hpp"

namespace raymarch::daemon
{
namespace
{

using namespace protocol; // NOLINT(google-build-using-namespace): this file speaks nothing else

/// Whether the request would change the registers.
bool writes(const Request& request) noexcept
{
    return request.kind == Request::Kind::Frame ||
           (request.kind == Request::Kind::Command && request.command->effect == Effect::Writes &&
            !(request.command->bare == Effect::Reads && request.text.empty()));
}

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
    const Request request = read_request(line, policy_.require_checksum);
    echoed_ += request.kind == Request::Kind::Reply ? 1 : 0;
    if (!request.answered())
        return {};
    reply_.begin(request.checksummed);
    const Outcome fault = dispatch(request, session, rest, turn_is_over);
    if (rest.any()) {
        rest.checksummed_ = request.checksummed;
        return {};
    }
    return settle(fault, writes(request) || request.kind == Request::Kind::Faulty,
                  request.checksummed);
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
    hold(state, pack(*accelerator_, state));
    return taken(board_.apply(words_));
}

void Controller::board_is_back(const Accelerator& accelerator)
{
    if (&accelerator != accelerator_)
        recall(accelerator);
    static_cast<void>(restore(state_)); // the board itself reports what it does not take
}

Controller::Outcome Controller::dispatch(const Request& request, SessionSettings& session,
                                         Unfinished& rest, const TurnIsOver& turn_is_over)
{
    if (request.kind == Request::Kind::Faulty)
        return request.fault;
    if (locked_ && writes(request))
        return Fault{.code = ErrorCode::Locked};
    if (request.kind == Request::Kind::Command) {
        if (auto fault = check_arity(request))
            return fault;
        return run(request.command->id, {request.text, session, rest, turn_is_over});
    }

    State state = state_;
    if (auto fault = read_frame(*accelerator_, request.text, state))
        return fault;
    return apply(state);
}

Controller::Outcome Controller::apply(const State& state)
{
    return apply(state, words_);
}

Controller::Outcome Controller::apply(const State& state, const Words& before)
{
    const bool orthonormal =
        policy_.basis_check == BasisCheck::Off || basis_is_orthonormal(*accelerator_, state);
    if (!orthonormal && policy_.basis_check == BasisCheck::Reject)
        return Fault{.code = ErrorCode::Basis};
    const Words words = pack(*accelerator_, state);
    if (!taken(board_.apply(words)))
        return Fault{.code = ErrorCode::Hardware};

    std::uint64_t changed = 0;
    for (std::size_t i = 0; i < accelerator_->word_count; ++i)
        changed += words[i] != before[i] ? 1 : 0;
    if (!(state == state_))
        storage_.changed(*accelerator_, state);
    hold(state, words);
    ++applied_;
    reply_ << "OK seq=" << applied_ << " changed=" << changed;
    if (!orthonormal)
        reply_ << " warn=" << error_row(ErrorCode::Basis).name;
    reply_.end_line();
    return std::nullopt;
}

void Controller::hold(const State& state, const Words& words)
{
    changes_ += state == state_ ? 0 : 1;
    state_ = state;
    words_ = words;
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
        put(state);
}

void Controller::to_defaults()
{
    State state = state_;
    reset(*accelerator_, {}, state);
    if (put(state))
        preset_.reset();
}

void Controller::to_next_scene()
{
    std::optional<std::size_t> preset = preset_;
    if (put(next_scene(*accelerator_, state_, preset)))
        preset_ = preset;
}

void Controller::orbit(Side side)
{
    State state = state_;
    movement_.orbit(*accelerator_, state, side);
    if (!(state == state_))
        put(state);
}

bool Controller::put(const State& state)
{
    const Words words = pack(*accelerator_, state);
    if (!taken(board_.apply(words)))
        return false; // as a line would be refused: the next step begins where this one did
    if (!(state == state_))
        storage_.changed(*accelerator_, state);
    hold(state, words);
    return true;
}

void Controller::ok()
{
    reply_ << "OK";
    reply_.end_line();
}

} // namespace raymarch::daemon
