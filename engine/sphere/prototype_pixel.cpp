// SPDX-License-Identifier: MIT
#include "engine/sphere/prototype_pixel.hpp"

#include "engine/sphere/light_falloff.hpp"
#include "engine/sphere/ray_sphere_unit.hpp"

#include <algorithm>
#include <optional>
#include <span>

namespace raymarch::engine::sphere
{
namespace
{

constexpr std::int64_t white = 255;

struct Visible
{
    std::size_t ball; ///< whose colour shows
    Strike strike;
};

/// The prototype takes the colour of the first sphere that the ray hits and the point of the last;
/// corrected, both are those of the nearest.
std::optional<Visible> look(const Frame& frame, const Rules& rules, const Line& ray) noexcept
{
    const bool nearest = frame.faults == Faults::Corrected;
    std::optional<Visible> visible;
    for (std::size_t i = 0; i < frame.ball_count; ++i) {
        const Strike strike = intersect(rules, ray, frame.balls[i], Reach::Ray, frame.derounder);
        if (strike.end != End::Hits)
            continue;
        if (!visible || (nearest && strike.root < visible->strike.root))
            visible = Visible{i, strike};
        else if (!nearest)
            visible->strike = strike;
    }
    return visible;
}

/// Says whether a sphere, the struck one among them, stands on the way; counts what it looks at.
bool blocked(const Frame& frame, const Rules& rules, const Line& way,
             std::uint32_t& evaluations) noexcept
{
    const std::span balls = std::span(frame.balls).first(frame.ball_count);
    return std::ranges::any_of(balls, [&](const Ball& ball) {
        ++evaluations;
        return intersect(rules, way, ball, Reach::Segment, frame.derounder).end == End::Hits;
    });
}

/// Returns the brightness that a light adds.
std::int64_t received(const Frame& frame, const Light& light, const Point& point) noexcept
{
    const std::uint64_t squared = squared_distance(point, light.position);
    const std::int64_t power = std::int64_t{light.strength} * frame.calibration;
    if (frame.faults != Faults::Corrected)
        return falloff(static_cast<std::int32_t>(power), squared); // a product of 32 bits
    return squared == 0 ? white : falloff(power, squared);
}

} // namespace

PrototypePixel prototype_pixel(const Frame& frame, std::int32_t x, std::int32_t y) noexcept
{
    const Rules& rules = rules_of(frame.design, frame.faults);
    PrototypePixel pixel{.evaluations = static_cast<std::uint32_t>(frame.ball_count)};
    const std::optional<Visible> visible = look(frame, rules, {frame.eye, {x, y, frame.screen}});
    if (!visible)
        return pixel;

    const Point& point = visible->strike.point;
    std::uint8_t brightness = 0; // modulo 256, should a product have wrapped below zero
    for (const Light& light : std::span(frame.lights).first(frame.light_count)) {
        ++pixel.rays;
        if (!blocked(frame, rules, {point, light.position}, pixel.evaluations))
            brightness = static_cast<std::uint8_t>(
                std::min(white, brightness + received(frame, light, point)));
    }
    const auto shadow = static_cast<std::uint8_t>(frame.shadow);
    pixel.colour.fill(shadow);
    pixel.colour[visible->ball] = std::max(brightness, shadow);
    return pixel;
}

} // namespace raymarch::engine::sphere
