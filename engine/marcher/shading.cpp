// SPDX-License-Identifier: MIT
#include "engine/marcher/shading.hpp"

#include <algorithm>

namespace raymarch::engine::marcher
{

Coordinate brightness(const Point& normal, const Point& light) noexcept
{
    const Product products =
        normal.x * light.x + normal.y * light.y + normal.z * light.z; // one shift for the sum
    const std::int32_t diffuse = std::max(narrow<Coordinate>(products).raw(), 0);
    const std::int32_t sky = std::max(normal.y.raw(), 0);
    return ratio(1, 8) + Coordinate::from_raw(sky >> 3) + Coordinate::from_raw((3 * diffuse) >> 2);
}

std::array<std::uint8_t, 3> shade(const std::array<std::uint16_t, 3>& colour,
                                  Coordinate brightness) noexcept
{
    constexpr int colour_bits = 10;
    constexpr int channel_bits = 8;
    constexpr int drop = Coordinate::fraction_bits + colour_bits - channel_bits;
    std::array<std::uint8_t, 3> channels{};
    for (std::size_t i = 0; i < channels.size(); ++i)
        channels[i] = static_cast<std::uint8_t>(
            std::min<std::int64_t>((std::int64_t{colour[i]} * brightness.raw()) >> drop, 255));
    return channels;
}

} // namespace raymarch::engine::marcher
