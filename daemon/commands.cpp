// SPDX-License-Identifier: MIT
/// How the controller executes each command.
#include "daemon/controller.hpp"
#include "protocol/accelerators.hpp"
#include "protocol/arguments.hpp"
#include "protocol/assignments.hpp"
#include "protocol/help.hpp"
#include "protocol/views.hpp"

#include <algorithm>
#include <array>

namespace raymarch::daemon
{

using namespace protocol; // NOLINT(google-build-using-namespace): as in controller.cpp

namespace
{

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

} // namespace

Controller::Outcome Controller::run(CommandId command, const Call& call)
{
    struct Row
    {
        CommandId command;
        Outcome (Controller::*execute)(const Call& call);
    };
    static constexpr std::array<Row, commands.size()> rows = {{
        {CommandId::Set, &Controller::assign},
        {CommandId::View, &Controller::set_view},
        {CommandId::Hue, &Controller::set_hue},
        {CommandId::Get, &Controller::get},
        {CommandId::Regs, &Controller::write_registers},
        {CommandId::Reset, &Controller::reset_group},
        {CommandId::Random, &Controller::draw_random},
        {CommandId::Status, &Controller::write_status},
        {CommandId::Preset, &Controller::preset},
        {CommandId::Save, &Controller::save},
        {CommandId::Load, &Controller::load},
        {CommandId::Accelerator, &Controller::switch_accelerator},
        {CommandId::Walk, &Controller::walk},
        {CommandId::Turn, &Controller::turn},
        {CommandId::Animate, &Controller::animate_at},
        {CommandId::Echo, &Controller::echo},
        {CommandId::Version, &Controller::write_version},
        {CommandId::Ping, &Controller::ping},
        {CommandId::Help, &Controller::help},
    }};
    static_assert([] {
        for (std::size_t i = 0; i < rows.size(); ++i)
            if (static_cast<std::size_t>(rows[i].command) != i)
                return false;
        return true;
    }()); // they stand in the order of the commands
    return (this->*rows[static_cast<std::size_t>(command)].execute)(call);
}

// --- values ---

Controller::Outcome Controller::assign(const Call& call)
{
    State state = state_;
    ParameterSet given;
    if (auto fault = read_assignments(*accelerator_, call.words, state, given))
        return fault;
    return apply(state);
}

Controller::Outcome Controller::set_view(const Call& call)
{
    State state = state_;
    if (auto fault = apply_view(*accelerator_, call.words, state))
        return fault;
    return apply(state);
}

Controller::Outcome Controller::set_hue(const Call& call)
{
    State state = state_;
    if (auto fault = apply_hue(*accelerator_, call.words, state))
        return fault;
    return apply(state);
}

Controller::Outcome Controller::get(const Call& call)
{
    reply_ << "OK ";
    if (call.words.empty()) {
        write_state(reply_, *accelerator_, state_);
        reply_.end_line();
        return std::nullopt;
    }
    ParameterSet given;
    Text rest = call.words;
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

Controller::Outcome Controller::write_registers(const Call& /*call*/)
{
    reply_ << "OK";
    write_words(reply_, *accelerator_, words_);
    reply_.end_line();
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

Controller::Outcome Controller::reset_group(const Call& call)
{
    State state = state_;
    std::string_view name;
    if (auto fault = group(call.words, name))
        return fault;
    reset(*accelerator_, name, state);
    return apply(state);
}

Controller::Outcome Controller::draw_random(const Call& call)
{
    State state = state_;
    std::string_view name;
    if (auto fault = group(call.words, name))
        return fault;
    randomise(*accelerator_, name, random_, state);
    return apply(state);
}

Controller::Outcome Controller::preset(const Call& call)
{
    if (call.words.empty()) {
        reply_ << "OK presets=";
        for (std::size_t i = 0; i < accelerator_->presets.size(); ++i)
            reply_ << (i == 0 ? "" : ",") << accelerator_->presets[i].name;
        reply_.end_line();
        return std::nullopt;
    }
    for (std::size_t i = 0; i < accelerator_->presets.size(); ++i) {
        const Preset& row = accelerator_->presets[i];
        if (!equal_ignoring_case(row.name, call.words.bytes))
            continue;
        Outcome fault = apply(preset_state(*accelerator_, row));
        if (!fault)
            preset_ = i;
        return fault;
    }
    return argument_fault(call.words, "PRESET alone lists the presets");
}

// --- what takes long: daemon/unfinished.cpp goes on with it ---

Controller::Outcome Controller::save(const Call& call)
{
    call.rest.what_ =
        Unfinished::Stored{CommandId::Save, accelerator_, storage_.save(*accelerator_, state_)};
    return go_on(call.rest, call.turn_is_over);
}

Controller::Outcome Controller::load(const Call& call)
{
    call.rest.what_ =
        Unfinished::Stored{CommandId::Load, accelerator_, storage_.load(*accelerator_)};
    return go_on(call.rest, call.turn_is_over);
}

Controller::Outcome Controller::walk(const Call& call)
{
    return move(read_walk(call.words), call.rest, call.turn_is_over);
}

Controller::Outcome Controller::turn(const Call& call)
{
    return move(read_turn(call.words), call.rest, call.turn_is_over);
}

Controller::Outcome Controller::animate_at(const Call& call)
{
    const auto rate = read_animate(call.words);
    if (!rate)
        return rate.error();
    rate_ = *rate;
    if (pace_)
        pace_(rate_);
    ok();
    return std::nullopt;
}

// --- the accelerator, the session and the service ---

Controller::Outcome Controller::switch_accelerator(const Call& call)
{
    if (!call.words.empty()) {
        const Accelerator* const wanted = find_accelerator(call.words.bytes);
        if (wanted == nullptr)
            return argument_fault(call.words, "HELP ACCELERATOR names the accelerators");
        if (wanted != accelerator_) {
            if (!board_.use(*wanted))
                return argument_fault(call.words, "only an emulated block can be switched");
            recall(*wanted);
            if (!restore(state_))
                return Fault{.code = ErrorCode::Hardware};
        }
    }
    reply_ << "OK accelerator=" << accelerator_->name;
    reply_.end_line();
    return std::nullopt;
}

Controller::Outcome Controller::echo(const Call& call)
{
    constexpr std::string_view allowed = "ECHO takes on or off";
    const OneWord first = one_word(call.words, allowed);
    const bool on = equal_ignoring_case(first.word, "on");
    if (!on && !equal_ignoring_case(first.word, "off"))
        return argument_fault(call.words, allowed);
    if (first.more)
        return first.more;
    call.session.echo = on;
    ok();
    return std::nullopt;
}

Controller::Outcome Controller::write_status(const Call& /*call*/)
{
    StatusValues status;
    status_.write_status(status);
    status.put(StatusKey::Accelerator, accelerator_->name);
    status.put(StatusKey::Animate, rate_);
    status.put(StatusKey::Locked, locked_ ? "on" : "off");
    status.put(StatusKey::Applied, applied_);
    status.put(StatusKey::Echoed, echoed_);
    status.put_rejected(rejected_);
    reply_ << "OK";
    status.write(reply_);
    reply_.end_line();
    return std::nullopt;
}

Controller::Outcome Controller::write_version(const Call& /*call*/)
{
    reply_ << "OK version=" << RAYMARCH_VERSION << " protocol=" << protocol_version;
    reply_.end_line();
    return std::nullopt;
}

Controller::Outcome Controller::ping(const Call& /*call*/)
{
    ok();
    return std::nullopt;
}

Controller::Outcome Controller::help(const Call& call)
{
    if (!write_help(reply_, *accelerator_, call.words.bytes))
        return argument_fault(call.words, "HELP alone lists what there is");
    ok();
    return std::nullopt;
}

} // namespace raymarch::daemon
