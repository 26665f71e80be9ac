// SPDX-License-Identifier: MIT
#include "engine/mandelbulb/ray_generator.hpp"

namespace raymarch::engine::mandelbulb
{
namespace
{

constexpr int component_shift = 12; ///< what brings a sum of three products back into 60 bits

/// floor(sqrt(a)), two bits a turn; 0 <= a < 2^122.
constexpr std::uint64_t floor_root(Int128 a) noexcept
{
    Int128 root{0};
    for (int bit = 120; bit >= 0; bit -= 2) {
        const Int128 trial = root + (Int128(1) << bit);
        root >>= 1;
        if (trial <= a) {
            a -= trial;
            root += Int128(1) << bit;
        }
    }
    return static_cast<std::uint64_t>(root);
}

/// (a << 57) / length, towards zero, one bit a turn; |a| <= length.
constexpr std::int64_t ratio(std::int64_t a, std::uint64_t length) noexcept
{
    std::uint64_t rest = static_cast<std::uint64_t>(a < 0 ? -a : a);
    std::int64_t quotient = 0;
    for (int i = 0; i <= direction_bits; ++i) {
        const bool fits = rest >= length;
        quotient = quotient * 2 + (fits ? 1 : 0);
        rest = (fits ? rest - length : rest) * 2;
    }
    return a < 0 ? -quotient : quotient;
}

} // namespace

Direction unit_vector(const Direction& v) noexcept
{
    const auto square = [](std::int64_t a) { return Int128(a) * Int128(a); };
    const std::uint64_t length = floor_root(square(v.x) + square(v.y) + square(v.z));
    if (length == 0)
        return {};
    return map(v, [&](std::int64_t a) { return ratio(a, length); });
}

Direction ray_vector(const Frame& frame, PictureSize size, std::uint16_t x,
                     std::uint16_t y) noexcept
{
    const int width = size.width;
    const int height = size.height;
    int u = 2 * x + 1 - width;
    if (frame.aspect == Aspect::Square)
        u = u * height / width;
    const int v = height - 1 - 2 * y;
    const int f = 2 * height;
    const auto component = [&](std::int64_t right, std::int64_t up, std::int64_t forward) {
        const Int128 sum =
            Int128(right) * Int128(u) + Int128(up) * Int128(v) + Int128(forward) * Int128(f);
        return static_cast<std::int64_t>(sum >> component_shift);
    };
    return {component(frame.right.x, frame.up.x, frame.forward.x),
            component(frame.right.y, frame.up.y, frame.forward.y),
            component(frame.right.z, frame.up.z, frame.forward.z)};
}

Direction ray_direction(const Frame& frame, PictureSize size, std::uint16_t x,
                        std::uint16_t y) noexcept
{
    return unit_vector(ray_vector(frame, size, x, y));
}

} // namespace raymarch::engine::mandelbulb
