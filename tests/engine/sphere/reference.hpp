// SPDX-License-Identifier: MIT
/// @file
/// The originals once more, straight from their description and with the wide numbers and doubles
/// that the engine does without: what random scenes are compared with. For scenes in range.
#pragma once

#include "engine/sphere/frame.hpp"

#include <array>
#include <cmath>
#include <cstdint>

#if defined(__SIZEOF_INT128__)

namespace raymarch::engine::sphere::reference
{

__extension__ using Int128 = __int128;
using Triple = std::array<std::int64_t, 3>;

inline Triple triple(const Point& p)
{
    return {p.x, p.y, p.z};
}

struct Answer
{
    int end = 1;
    Triple near{};
};

inline std::int64_t exact_root(Int128 v)
{
    Int128 low = 0;
    Int128 high = Int128{1} << 40;
    while (high - low > 1) {
        const Int128 middle = (low + high) / 2;
        (middle * middle <= v ? low : high) = middle;
    }
    return static_cast<std::int64_t>(low);
}

struct Unit
{
    bool hardware = true;
    std::int64_t derounder = 75;

    [[nodiscard]] Answer operator()(const Triple& p0, const Triple& p1, const Ball& ball,
                                    bool bounded, std::int64_t threshold) const
    {
        const Triple s = triple(ball.centre);
        std::int64_t a = 0;
        std::int64_t b = 0;
        std::int64_t c = -std::int64_t{ball.radius} * ball.radius;
        for (std::size_t k = 0; k < 3; ++k) {
            a += (p1[k] - p0[k]) * (p1[k] - p0[k]);
            b += 2 * (p1[k] - p0[k]) * (p0[k] - s[k]);
            c += (p0[k] - s[k]) * (p0[k] - s[k]);
        }
        const Int128 b2 = Int128{b} * b;
        const Int128 q = Int128{4} * a * c;
        if (hardware ? b2 <= q : b2 < q)
            return {1, {}};
        const std::int64_t root =
            hardware ? exact_root(b2 - q)
                     : static_cast<std::int32_t>(
                           std::sqrt(static_cast<double>(static_cast<std::int64_t>(b2 - q))));
        const std::int64_t t1 = -b + root - a / derounder;
        const std::int64_t t2 = -b - root - a / derounder;
        const auto below = [&](std::int64_t t) {
            return hardware ? static_cast<std::uint64_t>(t) < static_cast<std::uint64_t>(threshold)
                            : t < threshold;
        };
        if ((below(t1) && below(t2)) || a == 0 || (bounded && t1 > 2 * a && t2 > 2 * a))
            return {2, {}};
        Answer answer{3, {}};
        for (std::size_t k = 0; k < 3; ++k) {
            const std::int64_t first = hardware && k == 0 ? t1 : t2;
            const Int128 sum = Int128{first} * p1[k] + Int128{2 * a - t2} * p0[k];
            const auto quotient = static_cast<std::int64_t>(sum / (2 * a));
            answer.near[k] = hardware ? quotient & 0xFFFF : quotient;
        }
        return answer;
    }
};

inline std::int64_t squared(const Triple& a, const Triple& b)
{
    std::int64_t sum = 0;
    for (std::size_t k = 0; k < 3; ++k)
        sum += (a[k] - b[k]) * (a[k] - b[k]);
    return sum;
}

struct HardwarePixel
{
    int value = 0;
    int edges = 1008;
};

inline HardwarePixel hardware(const Frame& frame, int x, int y)
{
    const Unit unit{true, frame.derounder};
    const Answer primary = unit(triple(frame.eye), {x, y, frame.screen}, frame.balls[0], false, 0);
    if (primary.end != 3)
        return {};
    const Triple light = triple(frame.lights[0].position);
    const Answer shadow = unit(primary.near, light, frame.balls[0], true, 10);
    if (shadow.end == 3)
        return {2, 7012};
    const std::int64_t distance = squared(primary.near, light);
    const std::int64_t power = std::int64_t{frame.lights[0].strength} * frame.calibration;
    const std::int64_t value = distance == 0 ? 0 : power / distance;
    return {static_cast<int>(value > 15 ? 15 : value), shadow.end == 1 ? 4608 : 6108};
}

inline std::array<int, 3> prototype(const Frame& frame, int x, int y)
{
    const Unit unit{false, frame.derounder};
    Triple point{};
    int colour = -1;
    for (std::size_t i = 0; i < frame.ball_count; ++i) {
        const Answer answer =
            unit(triple(frame.eye), {x, y, frame.screen}, frame.balls[i], false, 0);
        if (answer.end != 3)
            continue;
        point = answer.near;
        if (colour < 0)
            colour = static_cast<int>(i);
    }
    if (colour < 0)
        return {0, 0, 0};
    std::array<int, 3> channels{};
    for (std::size_t l = 0; l < frame.light_count; ++l) {
        const Triple light = triple(frame.lights[l].position);
        bool blocked = false;
        for (std::size_t i = 0; i < frame.ball_count; ++i)
            blocked = blocked || unit(point, light, frame.balls[i], true, 10).end == 3;
        if (blocked)
            continue;
        const std::int64_t distance = squared(point, light);
        const std::int64_t power = std::int64_t{frame.lights[l].strength} * frame.calibration;
        const std::int64_t added = distance == 0 ? 0 : power / distance;
        int& channel = channels[static_cast<std::size_t>(colour)];
        channel = static_cast<int>(channel + added > 255 ? 255 : channel + added);
    }
    for (int& channel : channels)
        channel = channel < frame.shadow ? frame.shadow : channel;
    return channels;
}

} // namespace raymarch::engine::sphere::reference

#endif
