// SPDX-License-Identifier: MIT
#include "engine/sphere/rtl_pixel.hpp"

#include "engine/sphere/light_falloff.hpp"
#include "engine/sphere/ray_sphere_unit.hpp"

#include <algorithm>

namespace raymarch::engine::sphere
{
namespace
{

/// Returns the value of a pixel with light. Corrected, it is never darker than one without.
std::uint8_t lit_value(const Frame& frame, const Point& point) noexcept
{
    const Light& light = frame.lights[0];
    const std::uint64_t squared = squared_distance(point, light.position);
    const std::int64_t power = std::int64_t{light.strength} * frame.calibration;
    std::int64_t value = falloff(power, squared);
    if (frame.faults == Faults::Corrected)
        value = squared == 0 ? rtl_white : std::max<std::int64_t>(value, frame.shadow);
    return static_cast<std::uint8_t>(std::min<std::int64_t>(value, rtl_white));
}

} // namespace

RtlPixel rtl_pixel(const Frame& frame, std::int32_t x, std::int32_t y) noexcept
{
    const Rules& rules = rules_of(frame.design, frame.faults);
    const Ball& ball = frame.balls[0];
    const auto meet = [&](const Point& from, const Point& to, Reach reach) {
        return intersect(rules, {from, to}, ball, reach, frame.derounder);
    };

    const Strike strike = meet(frame.eye, {x, y, frame.screen}, Reach::Ray);
    if (strike.end != End::Hits)
        return {.outcome = strike.end == End::Misses ? Outcome::Missed : Outcome::Behind,
                .point = frame.eye};
    const Strike blocked = meet(strike.point, frame.lights[0].position, Reach::Segment);
    if (blocked.end == End::Hits)
        return {.value = static_cast<std::uint8_t>(std::min(frame.shadow, rtl_white)),
                .outcome = Outcome::Shadowed,
                .point = strike.point};
    return {.value = lit_value(frame, strike.point),
            .outcome = blocked.end == End::Misses ? Outcome::LitClear : Outcome::LitRejected,
            .point = strike.point};
}

} // namespace raymarch::engine::sphere
