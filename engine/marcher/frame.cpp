// SPDX-License-Identifier: MIT
#include "engine/marcher/frame.hpp"

#include "protocol/accelerators/marcher.hpp"
#include "protocol/registers.hpp"

#include <algorithm>

namespace raymarch::engine::marcher
{
namespace
{

constexpr std::int64_t max_zoom = std::int64_t{16} << Coordinate::fraction_bits;

} // namespace

Frame latch(std::span<const std::uint32_t> words) noexcept
{
    namespace table = protocol::marcher;
    const protocol::State state = protocol::unpack(table::description, words);
    const auto vector = [&](const std::array<protocol::ParameterIndex, 3>& at) {
        return RawVector{static_cast<std::int32_t>(state.codes[at[0]]),
                         static_cast<std::int32_t>(state.codes[at[1]]),
                         static_cast<std::int32_t>(state.codes[at[2]])};
    };

    Frame frame{};
    frame.forward = vector(table::description.camera->forward);
    frame.right = vector(table::description.camera->right);
    frame.up = vector(table::description.camera->up);
    const std::int64_t zoom = std::min(state.codes[table::ZM], max_zoom);
    frame.eye = map(frame.forward, [&](std::int32_t component) {
        return Coordinate::from_raw((zoom * component) >> table::direction_format.fraction_bits);
    });
    frame.light = map(vector({table::LX, table::LY, table::LZ}), [](std::int32_t code) {
        constexpr int shift = Coordinate::fraction_bits - table::light_format.fraction_bits;
        return Coordinate::from_raw(code * (std::int32_t{1} << shift));
    });
    for (std::size_t i = 0; i < frame.colour.size(); ++i)
        frame.colour[i] =
            static_cast<std::uint16_t>(state.codes[table::description.colour->channels[i]]);
    frame.scene = static_cast<Scene>(state.codes[table::OBJ]);
    return frame;
}

} // namespace raymarch::engine::marcher
