// SPDX-License-Identifier: MIT
/// How the controller executes each command.
#include "daemon/controller.hpp"
#include "motion/colour.hpp"
#include "motion/directions.hpp"
#include "motion/orbit_camera.hpp"
#include "motion/random_values.hpp"
#include "protocol/groups.hpp"
#include "protocol/help.hpp"
#include "protocol/views.hpp"

#include <string_view>

namespace raymarch::daemon
{

using namespace protocol; // NOLINT(google-build-using-namespace): as in controller.cpp

namespace
{

constexpr std::string_view protocol_version = "1";

/// The fault of a command that could be read and cannot be executed.
Fault refuse(std::size_t column, std::string_view why)
{
    return argument_fault({.bytes = {}, .column = column}, why);
}

} // namespace

// --- values ---

Controller::Outcome Controller::run(const Command<"SET">& set, const Call& /*call*/)
{
    const auto [state] = set.values;
    return apply(*state, words_);
}

Controller::Outcome Controller::run(const Command<"VIEW">& view, const Call& /*call*/)
{
    const auto [yaw, pitch, zoom] = view.values;
    State state = state_;
    motion::set_orbit(*accelerator_, yaw, pitch, state);
    state.codes[accelerator_->camera->zoom] = zoom;
    return apply(state, words_);
}

Controller::Outcome Controller::run(const Command<"HUE">& hue, const Call& /*call*/)
{
    State state = state_;
    motion::set_hue(*accelerator_, std::get<0>(hue.values), state);
    return apply(state, words_);
}

Controller::Outcome Controller::run(const Command<"GET">& get, const Call& /*call*/)
{
    reply_ << "OK ";
    if (const auto& [keys] = get.values; keys) {
        std::string_view separator;
        for (const ParameterIndex index : keys->indices) {
            reply_ << separator;
            write_assignment(reply_, *accelerator_, state_, index);
            separator = ",";
        }
    } else {
        protocol::write_state(reply_, *accelerator_, state_);
    }
    reply_.end_line();
    return std::nullopt;
}

Controller::Outcome Controller::run(const Command<"REGS">& /*regs*/, const Call& /*call*/)
{
    reply_ << "OK";
    write_words(reply_, *accelerator_, words_);
    reply_.end_line();
    return std::nullopt;
}

Controller::Outcome Controller::run(const Command<"RESET">& reset, const Call& /*call*/)
{
    const auto [group] = reset.values;
    State state = state_;
    protocol::reset(*accelerator_, group.value_or(""), state);
    return apply(state, words_);
}

Controller::Outcome Controller::run(const Command<"RANDOM">& random, const Call& /*call*/)
{
    const auto [group] = random.values;
    State state = state_;
    motion::randomise(*accelerator_, group.value_or(""), random_, state);
    return apply(state, words_);
}

Controller::Outcome Controller::run(const Command<"PRESET">& preset, const Call& /*call*/)
{
    const auto [wanted] = preset.values;
    if (wanted) {
        Outcome fault = apply(preset_state(*accelerator_, accelerator_->presets[*wanted]), words_);
        if (!fault)
            preset_ = wanted;
        return fault;
    }
    reply_ << "OK presets=";
    std::string_view separator;
    for (const Preset& row : accelerator_->presets) {
        reply_ << separator << row.name;
        separator = ",";
    }
    reply_.end_line();
    return std::nullopt;
}

// --- commands that may take long: daemon/unfinished.cpp goes on with them ---

Controller::Outcome Controller::run(const Command<"SAVE">& /*save*/, const Call& call)
{
    call.rest.what_ = Unfinished::Stored{Unfinished::Storing::Save, accelerator_,
                                         storage_.save(*accelerator_, state_)};
    return go_on(call.rest, call.turn_is_over);
}

Controller::Outcome Controller::run(const Command<"LOAD">& /*load*/, const Call& call)
{
    call.rest.what_ =
        Unfinished::Stored{Unfinished::Storing::Load, accelerator_, storage_.load(*accelerator_)};
    return go_on(call.rest, call.turn_is_over);
}

Controller::Outcome Controller::run(const Command<"WALK">& walk, const Call& call)
{
    const auto [direction, steps] = walk.values;
    return move({.inputs = motion::walk_inputs[direction], .count = steps.value_or(1)}, call);
}

Controller::Outcome Controller::run(const Command<"TURN">& turn, const Call& call)
{
    const auto [direction, steps] = turn.values;
    return move({.inputs = motion::turn_inputs[direction], .count = steps.value_or(1)}, call);
}

Controller::Outcome Controller::run(const Command<"ANIMATE">& animate, const Call& /*call*/)
{
    const auto [choice, rate] = animate.values;
    rate_ = on_or_off[choice] == "on" ? rate.value_or(usual_rate) : 0;
    if (pace_)
        pace_(rate_);
    return ok();
}

// --- the accelerator, the session and the service ---

Controller::Outcome Controller::run(const Command<"ACCELERATOR">& accelerator, const Call& /*call*/)
{
    const auto [wanted] = accelerator.values;
    if (wanted && *wanted != accelerator_) {
        if (!board_.use(**wanted))
            return refuse(accelerator.column, "only an emulated block can be switched");
        recall(**wanted);
        if (!restore(state_)) // the accelerator is switched all the same
            return Fault{.code = ErrorCode::Hardware};
    }
    reply_ << "OK accelerator=" << accelerator_->name;
    reply_.end_line();
    return std::nullopt;
}

Controller::Outcome Controller::run(const Command<"ECHO">& echo, const Call& call)
{
    call.session.echo = on_or_off[std::get<0>(echo.values)] == "on";
    return ok();
}

Controller::Outcome Controller::run(const Command<"STATUS">& /*status*/, const Call& /*call*/)
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

Controller::Outcome Controller::run(const Command<"VERSION">& /*version*/, const Call& /*call*/)
{
    reply_ << "OK version=" << RAYMARCH_VERSION << " protocol=" << protocol_version;
    reply_.end_line();
    return std::nullopt;
}

Controller::Outcome Controller::run(const Command<"PING">& /*ping*/, const Call& /*call*/)
{
    return ok();
}

Controller::Outcome Controller::run(const Command<"HELP">& help, const Call& /*call*/)
{
    const auto [word] = help.values;
    if (!write_help(reply_, *accelerator_, word.value_or("")))
        return refuse(help.column, "HELP alone lists what there is");
    return ok();
}

} // namespace raymarch::daemon
