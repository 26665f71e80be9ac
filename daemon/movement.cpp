// SPDX-License-Identifier: MIT
#include "daemon/movement.hpp"

#include "motion/directions.hpp"
#include "motion/movers.hpp"
#include "protocol/arguments.hpp"

#include <optional>
#include <string_view>

namespace raymarch::daemon
{
namespace
{

using motion::Input;
using protocol::Fault;

constexpr unsigned most_steps = 1000;
constexpr unsigned default_rate = 20;

using InputOf = std::optional<Input> (*)(std::string_view direction) noexcept;

tl::expected<Steps, Fault> read_steps(protocol::Text words, InputOf input_of,
                                      std::string_view allowed) noexcept
{
    const auto read = protocol::read_word_and_count(words, 1, most_steps, "STEPS is 1 to 1000");
    if (!read)
        return tl::unexpected(read.error());
    if (const auto input = input_of(read->word.bytes))
        return Steps{.inputs = *input, .count = read->count};
    return tl::unexpected(argument_fault(words, allowed));
}

} // namespace

tl::expected<Steps, Fault> read_walk(protocol::Text words) noexcept
{
    return read_steps(words, motion::walk_input, "HELP WALK names the directions");
}

tl::expected<Steps, Fault> read_turn(protocol::Text words) noexcept
{
    return read_steps(words, motion::turn_input, "HELP TURN names the directions");
}

tl::expected<unsigned, Fault> read_animate(protocol::Text words) noexcept
{
    const auto read =
        protocol::read_word_and_count(words, default_rate, most_rate, "RATE is 1 to 60");
    if (!read)
        return tl::unexpected(read.error());
    if (protocol::equal_ignoring_case(read->word.bytes, "on"))
        return read->count;
    if (!protocol::equal_ignoring_case(read->word.bytes, "off"))
        return tl::unexpected(argument_fault(words, "ANIMATE takes on or off"));
    if (read->word.bytes.size() < words.bytes.size())
        return tl::unexpected(argument_fault(words.from(read->word.bytes.size()).trimmed(),
                                             "ANIMATE off takes no rate"));
    return 0U;
}

void Movement::step(const protocol::Accelerator& accelerator, protocol::State& state,
                    motion::Inputs inputs)
{
    if (!mover_ || accelerator_ != &accelerator) { // none yet, or a long movement has taken it
        mover_ = motion::mover_of(accelerator);
        accelerator_ = &accelerator;
    }
    if (mover_)
        mover_->step(state, inputs);
}

void Movement::move(const protocol::Accelerator& accelerator, protocol::State& state, Steps& steps,
                    const TurnIsOver& turn_is_over)
{
    do {
        step(accelerator, state, steps.inputs);
        --steps.count;
    } while (steps.count > 0 && !turn_is_over());
}

void Movement::animate(const protocol::Accelerator& accelerator, protocol::State& state)
{
    step(accelerator, state, Input::Animate);
}

void Movement::orbit(const protocol::Accelerator& accelerator, protocol::State& state, Side side)
{
    const bool left = side == Side::Left;
    const protocol::State before = state;
    step(accelerator, state, left ? Input::TurnLeft : Input::TurnRight);
    if (state == before)
        step(accelerator, state, left ? Input::StrafeLeft : Input::StrafeRight);
}

} // namespace raymarch::daemon
