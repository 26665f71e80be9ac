// SPDX-License-Identifier: MIT
#include "protocol/views.hpp"

#include "protocol/assignments.hpp"
#include "protocol/registers.hpp"

#include <cassert>

namespace raymarch::protocol
{

State preset_state(const Accelerator& accelerator, const Preset& preset) noexcept
{
    State state = initial_state(accelerator);
    ParameterSet given;
    [[maybe_unused]] const auto fault =
        read_assignments(accelerator, {.bytes = preset.settings}, state, given);
    assert(!fault); // a test reads every preset
    return state;
}

State next_scene(const Accelerator& accelerator, const State& state,
                 std::optional<std::size_t>& shown) noexcept
{
    if (accelerator.scene) {
        State next = state;
        const auto scenes =
            static_cast<std::int64_t>(accelerator.parameters[*accelerator.scene].choices.size());
        next.codes[*accelerator.scene] = (state.codes[*accelerator.scene] + 1) % scenes;
        return next;
    }
    shown = shown ? (*shown + 1) % accelerator.presets.size() : 0;
    return preset_state(accelerator, accelerator.presets[*shown]);
}

std::array<bool, 3> colour_bits(const Accelerator& accelerator, const State& state) noexcept
{
    std::array<bool, 3> bits{};
    if (!accelerator.colour)
        return bits;
    for (std::size_t i = 0; i < bits.size(); ++i) {
        const ParameterIndex channel = accelerator.colour->channels[i];
        bits[i] = state.codes[channel] > accelerator.parameters[channel].largest_code / 2;
    }
    return bits;
}

} // namespace raymarch::protocol
