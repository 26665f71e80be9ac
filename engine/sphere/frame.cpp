// SPDX-License-Identifier: MIT
#include "engine/sphere/frame.hpp"

namespace raymarch::engine::sphere
{

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
