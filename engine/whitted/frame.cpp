// SPDX-License-Identifier: MIT
#include "engine/whitted/frame.hpp"

namespace raymarch::engine::whitted
{
namespace
{

constexpr Wide wide_integer(std::int64_t n) noexcept
{
    return Wide::from_raw(n * (std::int64_t{1} << Wide::fraction_bits));
}

} // namespace

Colour ray_colour(const std::array<std::uint8_t, 3>& five_bits) noexcept
{
    Colour colour{};
    for (std::size_t i = 0; i < colour.size(); ++i)
        colour[i] = static_cast<std::uint16_t>(five_bits[i] << 5);
    return colour;
}

Sphere make_sphere(const Vector& centre, std::uint16_t radius,
                   const std::array<std::uint8_t, 3>& colour, Weight reflect) noexcept
{
    const std::int32_t r = radius == 0 ? 1 : radius; // 0 has no inverse
    return {.centre = centre,
            .colour = ray_colour(colour),
            .reflect = reflect,
            .radius = wide_integer(r),
            .squared_radius = wide_integer(std::int64_t{r} * r),
            .inverse_radius = Word::from_raw((1 << fraction_bits) / r)};
}

Sphere make_light(const Vector& centre, std::uint16_t radius) noexcept
{
    Sphere light = make_sphere(centre, radius, {}, 0);
    light.colour = {brightest, brightest, brightest};
    return light;
}

} // namespace raymarch::engine::whitted
