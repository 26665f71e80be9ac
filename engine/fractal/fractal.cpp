// SPDX-License-Identifier: MIT
#include "engine/fractal/fractal.hpp"

#include "engine/fractal/checkerboard.hpp"
#include "engine/fractal/display.hpp"
#include "engine/fractal/ray_generator.hpp"
#include "engine/fractal/ray_marcher.hpp"
#include "engine/fractal/shading.hpp"

#include <algorithm>

namespace raymarch::engine::fractal
{

void draw_row(const Frame& frame, RowOf row, std::span<std::uint8_t> pixels,
              std::span<PixelCost> costs) noexcept
{
    const SceneRow& scene = scene_row(frame.scene);
    const Camera camera = camera_along(frame.forward);
    const Plane plane = plane_of(row.size);
    const Palette colours = palette(frame.colour ? Colouring::Hue : Colouring::Grey, frame.hue);
    for (unsigned at = row.columns.first; at < row.end(); at += row.columns.step) {
        const auto x = static_cast<std::uint16_t>(at);
        costs[x] = {};
        if (frame.checker && !in_half(row.frame, x, row.y))
            continue;
        const Point direction = ray_direction(camera, plane, x, row.y);
        const March ray = march(frame.position, direction, scene.distance);
        costs[x] = {.steps = ray.depth + 1U, .rays = 1};
        std::ranges::copy(colours[grey(frame, ray, x, row.y)],
                          pixels.begin() + std::ptrdiff_t{x} * 3);
    }
}

unsigned frames_of_a_still(const Frame& frame) noexcept
{
    return frame.checker ? checkerboard_frames : 1;
}

} // namespace raymarch::engine::fractal
