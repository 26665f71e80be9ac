// SPDX-License-Identifier: MIT
/// @file
/// A frame of the sphere tracer drawn whole, and the scenes of the recorded pictures.
#pragma once

#include "engine/sphere/sphere.hpp"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace raymarch::engine::sphere
{

inline constexpr PictureSize source_size{640, 480};

struct Drawing
{
    Image image;
    std::vector<PixelCost> costs;
};

inline Drawing draw_frame(const Frame& frame, PictureSize size = source_size)
{
    Drawing drawing{Image(size), std::vector<PixelCost>(std::size_t{size.width} * size.height)};
    for (std::uint16_t y = 0; y < size.height; ++y)
        draw_row(frame, {size, y}, drawing.image.row(y),
                 std::span(drawing.costs).subspan(std::size_t{y} * size.width, size.width));
    finish(frame, {drawing.image.rgb, drawing.costs});
    return drawing;
}

/// Frame A: the first that the hardware draws, one step of the animation after power-up.
inline Frame frame_a()
{
    Frame frame;
    frame.balls[0].centre.x = 325;
    return frame;
}

/// The prototype with its own scene.
inline Frame prototype_scene()
{
    Frame frame;
    frame.design = Design::Prototype;
    frame.screen = 300;
    frame.calibration = 75;
    frame.derounder = 25;
    frame.shadow = 25;
    frame.ball_count = 2;
    frame.balls[0] = {{200, 240, 400}, 100};
    frame.balls[1] = {{260, 100, 500}, 50};
    frame.light_count = 2;
    frame.lights[0] = {{50, 50, 500}, 150'000};
    frame.lights[1] = {{0, 350, 400}, 50'000};
    return frame;
}

/// The prototype with a scene like the hardware's.
inline Frame prototype_demo()
{
    Frame frame = prototype_scene();
    frame.screen = 1000;
    frame.derounder = 75;
    frame.ball_count = 1;
    frame.balls[0] = {{320, 240, 1100}, 100};
    frame.light_count = 1;
    frame.lights[0] = {{50, 50, 1000}, 60'000};
    return frame;
}

} // namespace raymarch::engine::sphere
