// SPDX-License-Identifier: MIT
#include "engine/mandelbulb/frame.hpp"

#include "protocol/accelerators/mandelbulb.hpp"
#include "protocol/registers.hpp"

namespace raymarch::engine::mandelbulb
{

Frame latch(std::span<const std::uint32_t> words) noexcept
{
    namespace table = protocol::mandelbulb;
    const protocol::State state = protocol::unpack(table::description, words);
    // No frame leaves the ranges of the table; other words count as its nearest end.
    const auto number = [&](table::Index at) {
        const protocol::Parameter& row = table::parameters[at];
        return static_cast<int>(std::clamp(state.codes[at], row.min_scaled, row.max_scaled));
    };
    const auto position = [&](table::Index at) {
        constexpr int tail_bits = 32;
        const Int128 end = Int128(4) << position_bits;
        const Int128 code = (Int128(state.codes[at]) << tail_bits) +
                            Int128(state.codes[static_cast<std::size_t>(at) + 1]);
        return std::clamp<Int128>(code, -end, end);
    };

    Frame frame{};
    frame.form = static_cast<Form>(state.codes[table::FORM]);
    frame.arithmetic.steps = number(table::N);
    const int kept_bits = number(table::K);
    frame.arithmetic.kept_bits = kept_bits == 0 ? automatic_kept_bits(frame.arithmetic.steps)
                                                : std::max(kept_bits, min_kept_bits);
    frame.arithmetic.power = number(table::POWER);
    frame.arithmetic.iterations = number(table::I);
    frame.arithmetic.derivative = static_cast<DerivativeForm>(state.codes[table::DERIVATIVE]);
    frame.arithmetic.scale = number(table::SCALE);
    frame.epsilon_shift = number(table::B);
    frame.max_evaluations = number(table::STEPS);
    frame.colour = static_cast<ColourMode>(state.codes[table::COLOUR]);
    frame.aspect = static_cast<Aspect>(state.codes[table::ASPECT]);
    frame.position = {position(table::X), position(table::Y), position(table::Z)};
    frame.forward = {state.codes[table::FX], state.codes[table::FY], state.codes[table::FZ]};
    frame.right = {state.codes[table::RX], state.codes[table::RY], state.codes[table::RZ]};
    frame.up = {state.codes[table::UX], state.codes[table::UY], state.codes[table::UZ]};
    return frame;
}

} // namespace raymarch::engine::mandelbulb
