// SPDX-License-Identifier: MIT
#include "daemon/session.hpp"

#include <utility>

namespace raymarch::daemon
{

Step Session::step(std::string_view& bytes, const TurnIsOver& turn_is_over)
{
    if (rest_.waits())
        return Step::Waits;
    if (rest_.any()) {
        if (!has_room())
            return Step::Full;
        push(controller_.resume(rest_, turn_is_over));
        return Step::Done;
    }
    if (bytes.empty())
        return Step::Hungry;
    if (!has_room())
        return Step::Full;
    if (settings_.echo)
        return type(bytes, turn_is_over);
    const auto line = reader_.next(bytes);
    if (!line)
        return Step::Hungry;
    execute(*line, turn_is_over);
    if (settings_.echo) // the LF of this line may still come
        editor_.set_after_cr(reader_.after_cr());
    return Step::Done;
}

void Session::receive(std::string_view bytes)
{
    const bool reads = std::exchange(reads_, false);
    while (step(bytes, [] { return false; }) == Step::Done) {
    }
    reads_ = reads;
}

/// One typed line, or as much of it as there is.
Step Session::type(std::string_view& bytes, const TurnIsOver& turn_is_over)
{
    while (!bytes.empty()) {
        if (!has_room())
            return Step::Full;
        const protocol::Typed typed = editor_.type(bytes.front());
        bytes.remove_prefix(1);
        output_.push(typed.echo);
        if (!typed.line_ended)
            continue;
        const std::string_view line = editor_.line();
        execute({.bytes = line.substr(0, protocol::max_line_length),
                 .too_long = line.size() > protocol::max_line_length},
                turn_is_over);
        if (!settings_.echo)
            reader_.set_after_cr(editor_.after_cr());
        return Step::Done;
    }
    return Step::Hungry;
}

void Session::execute(const protocol::Line& line, const TurnIsOver& turn_is_over)
{
    push(controller_.execute(line, settings_, rest_, turn_is_over));
}

void Session::push(std::string_view reply) noexcept
{
    if (!reply.empty() && !output_.push_reply(reply))
        ++dropped_replies_;
}

void Session::hang_up() noexcept
{
    reader_.reset();
    editor_.reset();
    rest_ = {};
    drop_output();
    settings_ = {};
    reads_ = true;
    ++hang_ups_;
}

} // namespace raymarch::daemon
