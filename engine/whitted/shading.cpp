// SPDX-License-Identifier: MIT
#include "engine/whitted/shading.hpp"

#include <algorithm>

namespace raymarch::engine::whitted
{
namespace
{

/// The upper 12 of 24 bits.
std::uint16_t weighted(std::uint16_t value, Weight weight) noexcept
{
    return static_cast<std::uint16_t>((std::uint32_t{value} * weight) >> fraction_bits);
}

template <typename Function>
Colour channels(const Colour& a, const Colour& b, Function function) noexcept
{
    Colour result{};
    for (std::size_t i = 0; i < result.size(); ++i)
        result[i] = static_cast<std::uint16_t>(function(a[i], b[i]));
    return result;
}

} // namespace

Weight cosine_weight(Wide cosine, Highlight highlight) noexcept
{
    const std::int64_t steps = cosine.raw() >> fraction_bits;
    if (highlight == Highlight::Held)
        return static_cast<Weight>(std::min<std::int64_t>(steps, full_weight));
    return static_cast<Weight>(steps & full_weight);
}

Colour ambient(const Colour& colour) noexcept
{
    return channels(colour, colour, [](int c, int) { return c >> 1; });
}

Colour lambert(const Colour& colour, Weight cosine) noexcept
{
    return channels(colour, ambient(colour), [=](std::uint16_t full, std::uint16_t half) {
        return weighted(full, cosine) + half;
    });
}

Colour accumulate(const Colour& sum, const Colour& colour, Weight weight) noexcept
{
    return channels(sum, colour, [=](int so_far, std::uint16_t c) {
        return std::min<int>(so_far + weighted(c, weight), brightest);
    });
}

Weight reflected_weight(Weight weight, Weight reflect) noexcept
{
    return weighted(weight, reflect);
}

} // namespace raymarch::engine::whitted
