// SPDX-License-Identifier: MIT
#include "engine/marcher/marcher.hpp"

#include "engine/marcher/frame.hpp"
#include "engine/marcher/ray_generator.hpp"
#include "engine/marcher/ray_marcher.hpp"
#include "engine/marcher/shading.hpp"
#include "engine/marcher/surface_vectors.hpp"

#include <algorithm>

namespace raymarch::engine::marcher
{

void draw_row(const Frame& frame, RowOf row, std::span<std::uint8_t> pixels,
              std::span<PixelCost> costs) noexcept
{
    const SceneRow& scene = scene_row(frame.scene);
    for (unsigned at = row.columns.first; at < row.end(); at += row.columns.step) {
        const auto x = static_cast<std::uint16_t>(at);
        const Point direction = ray_direction(frame, row.size, x, row.y);
        const March ray = march(frame.eye, direction, scene.distance);
        costs[x] = {.steps = static_cast<std::uint32_t>(ray.queries), .rays = 1};
        std::array<std::uint8_t, 3> colour{}; // a miss is black
        if (ray.hit) {
            const Point normal = surface_normal(ray.point, scene.distance);
            const Point light = light_direction(ray.point, frame.light);
            colour = shade(frame.colour, brightness(normal, light));
        }
        std::ranges::copy(colour, pixels.begin() + std::ptrdiff_t{x} * 3);
    }
}

std::uint64_t frame_cycles(const Frame& frame, RowOf /*last_row*/, std::span<const PixelCost> costs,
                           unsigned units) noexcept
{
    std::uint64_t queries = 0;
    for (const PixelCost& cost : costs)
        queries += cost.steps;
    return (queries * scene_row(frame.scene).clock_cycles + units - 1) / units;
}

} // namespace raymarch::engine::marcher
