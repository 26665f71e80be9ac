// SPDX-License-Identifier: MIT
#include "engine/whitted/pixel.hpp"

#include "engine/whitted/ray_setup.hpp"
#include "engine/whitted/tracer.hpp"

namespace raymarch::engine::whitted
{
namespace
{

constexpr int dropped_bits = 5; // of 10

} // namespace

Pixel draw_pixel(const Frame& frame, PictureSize size, unsigned x, unsigned y) noexcept
{
    Pixel pixel{};
    Colour sum{};
    Sample sample;
    bool first = true;
    for (const SamplePlace& place : sample_places(frame.anti_aliasing)) {
        const Vector direction = primary_direction(frame, size, x, y, place);
        sample = trace(frame, direction);
        for (std::size_t i = 0; i < sum.size(); ++i)
            sum[i] = static_cast<std::uint16_t>(sum[i] + (sample.colour[i] >> place.shift));
        pixel.cost.steps += sample.cost.steps;
        pixel.cost.rays += sample.cost.rays;
        if (first)
            pixel.word.light = sample.sees_light;
        first = false;
    }
    if (frame.defects.has(Defect::LastHitIsLight))
        pixel.word.light = sample.ends_at_light;
    for (std::size_t i = 0; i < sum.size(); ++i)
        pixel.word.channels[i] = static_cast<std::uint8_t>(sum[i] >> dropped_bits);
    if (y == 0 && frame.defects.has(Defect::UnsignedPixel))
        pixel.word = {};
    return pixel;
}

std::array<std::uint8_t, 3> displayed(const FrameWord& word) noexcept
{
    std::array<std::uint8_t, 3> bytes{};
    for (std::size_t i = 0; i < bytes.size(); ++i)
        bytes[i] = static_cast<std::uint8_t>(word.channels[i] << 3 | (word.light ? 7 : 0));
    return bytes;
}

} // namespace raymarch::engine::whitted
