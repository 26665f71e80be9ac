// SPDX-License-Identifier: MIT
#include "engine/mandelbulb/mandelbulb.hpp"

#include "engine/mandelbulb/colouring.hpp"
#include "engine/mandelbulb/ray_generator.hpp"
#include "engine/mandelbulb/ray_marcher.hpp"

#include <cstddef>

namespace raymarch::engine::mandelbulb
{
namespace
{

constexpr unsigned cores = 5; ///< in the pipeline; an orbit passes them again and again

template <typename Format>
void draw_row_in(const Frame& frame, RowOf row, std::span<std::uint8_t> pixels,
                 std::span<PixelCost> costs) noexcept
{
    const Point<Format> origin = position_in<Format>(frame.position);
    const Limits limits{frame.epsilon_shift, frame.max_evaluations};
    for (unsigned at = row.columns.first; at < row.end(); at += row.columns.step) {
        const auto x = static_cast<std::uint16_t>(at);
        const Direction direction = ray_direction(frame, row.size, x, row.y);
        const March<Format> ray = march<Format>(origin, direction, frame.arithmetic, limits);
        costs[x] = {.steps = static_cast<std::uint32_t>(ray.evaluations), .rays = 1};
        const Rgb colour = ray.outcome == Outcome::Miss
                               ? step_colours[0]
                               : colour_of(frame.colour, ray.evaluations, ray.index);
        std::uint8_t* const pixel = pixels.data() + std::size_t{3} * x;
        pixel[0] = static_cast<std::uint8_t>(colour >> 16);
        pixel[1] = static_cast<std::uint8_t>(colour >> 8);
        pixel[2] = static_cast<std::uint8_t>(colour);
    }
}

} // namespace

void draw_row(const Frame& frame, RowOf row, std::span<std::uint8_t> pixels,
              std::span<PixelCost> costs) noexcept
{
    if (frame.form == Form::Q8_57)
        draw_row_in<Q57<Int128>>(frame, row, pixels, costs);
    else
        draw_row_in<Q64<Int128>>(frame, row, pixels, costs);
}

std::uint64_t frame_cycles(const Frame& frame, RowOf /*last_row*/, std::span<const PixelCost> costs,
                           unsigned units) noexcept
{
    std::uint64_t evaluations = 0;
    for (const PixelCost& cost : costs)
        evaluations += cost.steps;
    const unsigned passes =
        (static_cast<unsigned>(frame.arithmetic.iterations) + cores - 1) / cores;
    const unsigned stages = 22 * static_cast<unsigned>(frame.arithmetic.steps) + 392;
    return passes * ((evaluations + units - 1) / units + stages);
}

} // namespace raymarch::engine::mandelbulb
