// SPDX-License-Identifier: MIT
#include "engine/sphere/frame.hpp"

#include "protocol/accelerators/sphere.hpp"
#include "protocol/registers.hpp"

#include <algorithm>

namespace raymarch::engine::sphere
{

Frame latch(std::span<const std::uint32_t> words) noexcept
{
    namespace table = protocol::sphere;
    const protocol::State state = protocol::unpack(table::description, words);
    const auto number = [&](std::size_t at) { return static_cast<std::int32_t>(state.codes[at]); };
    const auto point = [&](std::size_t at) {
        return Point{number(at), number(at + 1), number(at + 2)};
    };

    Frame frame;
    frame.design = static_cast<Design>(number(table::MODEL));
    frame.faults = static_cast<Faults>(
        std::min(number(table::FAULTS), static_cast<std::int32_t>(Faults::Corrected)));
    frame.tint = static_cast<Tint>(number(table::TINT));
    frame.eye = point(table::EX);
    frame.screen = number(table::F);
    frame.calibration = number(table::K);
    frame.derounder = number(table::D);
    frame.shadow = number(table::CUTOFF);
    frame.ball_count = std::min(static_cast<std::size_t>(number(table::N)), max_balls);
    frame.light_count = std::min(static_cast<std::size_t>(number(table::M)), max_lights);
    for (std::size_t i = 0; i < max_balls; ++i) {
        const std::size_t row = table::S1 + i * table::SphereKeys::columns;
        frame.balls[i] = {point(row), number(row + 3)};
    }
    for (std::size_t i = 0; i < max_lights; ++i) {
        const std::size_t row = table::L1 + i * table::LightKeys::columns;
        frame.lights[i] = {point(row), number(row + 3)};
    }
    return frame;
}

Frame held(Frame frame) noexcept
{
    if (frame.design == Design::Prototype || frame.faults == Faults::Corrected)
        return frame;
    const auto word = [](std::int32_t value) { return value & 0xFFFF; };
    frame.eye = map(frame.eye, word);
    frame.screen = word(frame.screen);
    frame.calibration &= 0x3FF;
    frame.shadow &= 0xF;
    for (Ball& ball : frame.balls)
        ball = {map(ball.centre, word), word(ball.radius)};
    for (Light& light : frame.lights)
        light = {map(light.position, word), word(light.strength)};
    return frame;
}

} // namespace raymarch::engine::sphere
