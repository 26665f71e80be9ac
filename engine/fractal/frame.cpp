// SPDX-License-Identifier: MIT
#include "engine/fractal/frame.hpp"

#include "protocol/accelerators/fractal.hpp"
#include "protocol/registers.hpp"

namespace raymarch::engine::fractal
{

Frame latch(std::span<const std::uint32_t> words) noexcept
{
    namespace table = protocol::fractal;
    const protocol::State state = protocol::unpack(table::description, words);
    const auto number = [&](protocol::ParameterIndex at) {
        return Number::from_raw(state.codes[at]);
    };
    const auto is_on = [&](protocol::ParameterIndex at) { return state.codes[at] != 0; };
    return {.position = {number(table::X), number(table::Y), number(table::Z)},
            .forward = {number(table::FX), number(table::FY), number(table::FZ)},
            .scene = static_cast<Scene>(state.codes[table::SCENE]),
            .dither = is_on(table::DITHER),
            .texture = is_on(table::TEXTURE),
            .checker = is_on(table::CHECKER),
            .colour = is_on(table::COLOUR),
            .hue = static_cast<std::uint8_t>(state.codes[table::HUE])};
}

} // namespace raymarch::engine::fractal
