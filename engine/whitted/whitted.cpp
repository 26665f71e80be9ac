// SPDX-License-Identifier: MIT
#include "engine/whitted/whitted.hpp"

#include "engine/whitted/cycles.hpp"
#include "engine/whitted/pixel.hpp"

#include <algorithm>

namespace raymarch::engine::whitted
{

std::uint64_t frame_cycles(const Frame& frame, RowOf last_row, std::span<const PixelCost> costs,
                           unsigned units) noexcept
{
    return (frame_cost(frame, last_row.size, costs).cycles + units - 1) / units;
}

std::uint64_t frame_rays(const Frame& frame, PictureSize size,
                         std::span<const PixelCost> costs) noexcept
{
    return frame_cost(frame, size, costs).rays;
}

void draw_row(const Frame& frame, RowOf row, std::span<std::uint8_t> pixels,
              std::span<PixelCost> costs) noexcept
{
    for (unsigned x = row.columns.first; x < row.end(); x += row.columns.step) {
        const Pixel pixel = draw_pixel(frame, row.size, x, row.y);
        std::ranges::copy(displayed(pixel.word), pixels.begin() + std::ptrdiff_t{3} * x);
        costs[x] = pixel.cost;
    }
}

FrameCost frame_cost(const Frame& frame, PictureSize size,
                     std::span<const PixelCost> costs) noexcept
{
    FrameCost sum{.cycles = cycles::end_of_frame, .rays = 0};
    const auto add = [&](const PixelCost& cost) {
        sum.cycles += cost.steps;
        sum.rays += cost.rays;
    };
    std::ranges::for_each(costs, add);
    if (frame.defects.has(Defect::ExtraPixels)) {
        for (unsigned x = 0; x <= size.width; ++x)
            add(draw_pixel(frame, size, x, size.height).cost);
        for (unsigned y = 0; y < size.height; ++y)
            add(draw_pixel(frame, size, size.width, y).cost);
    }
    return sum;
}

} // namespace raymarch::engine::whitted
