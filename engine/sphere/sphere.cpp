// SPDX-License-Identifier: MIT
#include "engine/sphere/sphere.hpp"

#include "engine/sphere/prototype_pixel.hpp"
#include "engine/sphere/rtl_pixel.hpp"
#include "engine/sphere/timeline.hpp"

#include <algorithm>
#include <array>
#include <cstddef>

namespace raymarch::engine::sphere
{
namespace
{

using Colour = std::array<std::uint8_t, bytes_per_pixel>;

constexpr std::uint64_t longest_evaluation = 3500; ///< the unit's count at a hit

/// A value of 4 bits on the screen's red and green, or on all three.
Colour tinted(Tint tint, std::uint8_t value) noexcept
{
    const auto bright = static_cast<std::uint8_t>(value * 17);
    return {bright, bright, tint == Tint::Grey ? bright : std::uint8_t{0}};
}

} // namespace

Pixel draw_pixel(const Frame& registers, std::int32_t x, std::int32_t y) noexcept
{
    if (registers.design == Design::Prototype) {
        const PrototypePixel pixel = prototype_pixel(registers, x, y);
        return {pixel.colour, {.steps = pixel.evaluations, .rays = pixel.rays}};
    }
    const RtlPixel pixel = rtl_pixel(registers, x, y);
    const OutcomeRow& row = row_of(pixel.outcome);
    return {tinted(registers.tint, pixel.value), {.steps = row.period, .rays = row.rays}};
}

void draw_row(const Frame& frame, RowOf row, std::span<std::uint8_t> pixels,
              std::span<PixelCost> costs) noexcept
{
    const Frame registers = held(frame);
    for (unsigned at = row.columns.first; at < row.end(); at += row.columns.step) {
        const auto x = static_cast<std::uint16_t>(at);
        const Pixel pixel = draw_pixel(registers, x, row.y);
        std::ranges::copy(pixel.colour, pixels.begin() + std::ptrdiff_t{x} * 3);
        costs[x] = pixel.cost;
    }
}

void finish(const Frame& frame, const Canvas& canvas) noexcept
{
    const bool timed = frame.design == Design::RtlTimed;
    if (frame.faults == Faults::Corrected || (frame.design != Design::RtlTop && !timed))
        return;

    Colour before{};   // what the core showed for the pixel before: it is written one late
    Colour quotient{}; // in the divider's output register, held at white as the pixel is
    std::uint64_t enable = first_enable;
    for (std::size_t i = 0; i < canvas.costs.size(); ++i) {
        const auto pixel = canvas.rgb.subspan(i * bytes_per_pixel, bytes_per_pixel);
        const OutcomeRow& row = row_of_period(canvas.costs[i].steps);
        Colour shown{};
        std::ranges::copy(pixel, shown.begin());
        if (row.lit) {
            const Colour own = shown;
            if (timed && !divider_in_time(enable, row))
                shown = quotient;
            quotient = own;
        }
        std::ranges::copy(before, pixel.begin());
        before = shown;
        enable += row.period;
    }
}

std::uint64_t frame_cycles(const Frame& frame, RowOf /*last_row*/, std::span<const PixelCost> costs,
                           unsigned units) noexcept
{
    std::uint64_t steps = 0;
    for (const PixelCost& cost : costs)
        steps += cost.steps;
    const std::uint64_t edges =
        frame.design == Design::Prototype ? steps * longest_evaluation : steps;
    return (edges + units - 1) / units;
}

} // namespace raymarch::engine::sphere
