// SPDX-License-Identifier: MIT
#include "daemon/controller.hpp"

#include "protocol/accelerators.hpp"
#include "protocol/arguments.hpp"
#include "protocol/assignments.hpp"
#include "protocol/help.hpp"
#include "protocol/views.hpp"

#include <algorithm>

namespace raymarch::daemon
{
namespace
{

using namespace protocol; // NOLINT(google-build-using-namespace): this file speaks nothing else

constexpr std::string_view protocol_version = "1";

/// The first word, and a fault for a second one.
struct OneWord
{
    std::string_view word;
    std::optional<Fault> more;
};
OneWord one_word(Text words, std::string_view allowed) noexcept
{
    const std::size_t end = std::min(words.bytes.find_first_of(" \t"), words.bytes.size());
    OneWord result{words.bytes.substr(0, end), std::nullopt};
    if (end < words.bytes.size())
        result.more = argument_fault(words.from(end).trimmed(), allowed);
    return result;
}

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
        return run(request, session, rest, turn_is_over);
    }

    State state = state_;
    if (auto fault = read_frame(*accelerator_, request.text, state))
        return fault;
    return apply(state);
}

Controller::Outcome Controller::run(const Request& request, SessionSettings& session,
                                    Unfinished& rest, const TurnIsOver& turn_is_over)
{
    State state = state_;
    std::string_view group_name;
    switch (request.command->id) {
    case CommandId::Set:
        return assign(request.text);
    case CommandId::View:
        if (auto fault = apply_view(*accelerator_, request.text, state))
            return fault;
        return apply(state);
    case CommandId::Hue:
        if (auto fault = apply_hue(*accelerator_, request.text, state))
            return fault;
        return apply(state);
    case CommandId::Get:
        return get(request.text);
    case CommandId::Regs:
        reply_ << "OK";
        write_words(reply_, *accelerator_, words_);
        reply_.end_line();
        return std::nullopt;
    case CommandId::Reset:
        if (auto fault = group(request.text, group_name))
            return fault;
        reset(*accelerator_, group_name, state);
        return apply(state);
    case CommandId::Random:
        if (auto fault = group(request.text, group_name))
            return fault;
        randomise(*accelerator_, group_name, random_, state);
        return apply(state);
    case CommandId::Status:
        status();
        return std::nullopt;
    case CommandId::Preset:
        return preset(request.text);
    case CommandId::Save:
        rest.what_ =
            Unfinished::Stored{CommandId::Save, accelerator_, storage_.save(*accelerator_, state_)};
        return go_on(rest, turn_is_over);
    case CommandId::Load:
        rest.what_ =
            Unfinished::Stored{CommandId::Load, accelerator_, storage_.load(*accelerator_)};
        return go_on(rest, turn_is_over);
    case CommandId::Accelerator:
        return switch_accelerator(request.text);
    case CommandId::Walk:
        return move(read_walk(request.text), rest, turn_is_over);
    case CommandId::Turn:
        return move(read_turn(request.text), rest, turn_is_over);
    case CommandId::Animate:
        return animate_at(request.text);
    case CommandId::Echo:
        return echo(request.text, session);
    case CommandId::Version:
        reply_ << "OK version=" << RAYMARCH_VERSION << " protocol=" << protocol_version;
        reply_.end_line();
        return std::nullopt;
    case CommandId::Ping:
        ok();
        return std::nullopt;
    case CommandId::Help:
        if (!write_help(reply_, *accelerator_, request.text.bytes))
            return argument_fault(request.text, "HELP alone lists what there is");
        ok();
        return std::nullopt;
    }
    return Fault{.code = ErrorCode::UnknownCommand};
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

Controller::Outcome Controller::assign(Text words)
{
    State state = state_;
    ParameterSet given;
    if (auto fault = read_assignments(*accelerator_, words, state, given))
        return fault;
    return apply(state);
}

Controller::Outcome Controller::get(Text words)
{
    reply_ << "OK ";
    if (words.empty()) {
        write_state(reply_, *accelerator_, state_);
        reply_.end_line();
        return std::nullopt;
    }
    ParameterSet given;
    Text rest = words;
    for (bool more = true; more;) {
        const Piece piece = take_until(rest, ',');
        more = piece.found;
        const Text key = piece.text.trimmed();
        const auto index = find_parameter(*accelerator_, key.bytes);
        if (!index || given[*index]) {
            Fault fault = argument_fault(key, "GET takes the keys of parameters, each once");
            if (std::ranges::all_of(key.bytes, is_letter))
                fault.word = key.bytes;
            return fault;
        }
        if (given.any())
            reply_ << ',';
        given.set(*index);
        write_assignment(reply_, *accelerator_, state_, *index);
    }
    reply_.end_line();
    return std::nullopt;
}

Controller::Outcome Controller::preset(Text words)
{
    if (words.empty()) {
        reply_ << "OK presets=";
        for (std::size_t i = 0; i < accelerator_->presets.size(); ++i)
            reply_ << (i == 0 ? "" : ",") << accelerator_->presets[i].name;
        reply_.end_line();
        return std::nullopt;
    }
    for (std::size_t i = 0; i < accelerator_->presets.size(); ++i) {
        const Preset& row = accelerator_->presets[i];
        if (!equal_ignoring_case(row.name, words.bytes))
            continue;
        Outcome fault = apply(preset_state(*accelerator_, row));
        if (!fault)
            preset_ = i;
        return fault;
    }
    return argument_fault(words, "PRESET alone lists the presets");
}

void Controller::recall(const Accelerator& accelerator)
{
    accelerator_ = &accelerator;
    preset_.reset();
    ++changes_;
    state_ = storage_.last(accelerator).value_or(initial_state(accelerator));
    words_ = pack(accelerator, state_);
}

Controller::Outcome Controller::switch_accelerator(Text words)
{
    if (!words.empty()) {
        const Accelerator* const wanted = find_accelerator(words.bytes);
        if (wanted == nullptr)
            return argument_fault(words, "HELP ACCELERATOR names the accelerators");
        if (wanted != accelerator_) {
            if (!board_.use(*wanted))
                return argument_fault(words, "only an emulated block can be switched");
            recall(*wanted);
            if (!restore(state_))
                return Fault{.code = ErrorCode::Hardware};
        }
    }
    reply_ << "OK accelerator=" << accelerator_->name;
    reply_.end_line();
    return std::nullopt;
}

Controller::Outcome Controller::animate_at(Text words)
{
    const auto rate = read_animate(words);
    if (!rate)
        return rate.error();
    rate_ = *rate;
    if (pace_)
        pace_(rate_);
    ok();
    return std::nullopt;
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

Controller::Outcome Controller::echo(Text words, SessionSettings& session)
{
    constexpr std::string_view allowed = "ECHO takes on or off";
    const OneWord first = one_word(words, allowed);
    const bool on = equal_ignoring_case(first.word, "on");
    if (!on && !equal_ignoring_case(first.word, "off"))
        return argument_fault(words, allowed);
    if (first.more)
        return first.more;
    session.echo = on;
    ok();
    return std::nullopt;
}

Controller::Outcome Controller::group(Text words, std::string_view& name) const
{
    if (words.empty())
        return std::nullopt;
    const OneWord first = one_word(words, "one group, or none for all");
    const auto found = find_group(*accelerator_, first.word);
    if (!found)
        return argument_fault(words, "HELP RESET names the groups");
    if (first.more)
        return first.more;
    name = *found;
    return std::nullopt;
}

void Controller::status()
{
    std::uint64_t rejected = 0;
    for (const std::uint64_t count : rejected_)
        rejected += count;
    reply_ << "OK accelerator=" << accelerator_->name;
    status_.write_status(reply_);
    reply_ << " animate=" << std::uint64_t{rate_} << " locked=" << (locked_ ? "on" : "off")
           << " applied=" << applied_ << " rejected=" << rejected << " echoed=" << echoed_;
    for (const ErrorRow& row : errors)
        if (const std::uint64_t count = rejected_[static_cast<std::size_t>(row.code)]; count > 0)
            reply_ << " rejected." << row.name << '=' << count;
    reply_.end_line();
}

void Controller::ok()
{
    reply_ << "OK";
    reply_.end_line();
}

} // namespace raymarch::daemon
