// SPDX-License-Identifier: MIT
#include "engine/whitted/frame.hpp"

#include "protocol/accelerators/whitted.hpp"
#include "protocol/registers.hpp"

#include <algorithm>

namespace raymarch::engine::whitted
{
namespace
{

namespace table = protocol::whitted;

/// The values of one row of a table, or of no row: codes by their columns.
template <typename Column>
struct Row
{
    const protocol::State& state;
    std::size_t index;

    [[nodiscard]] std::int64_t code(Column column) const noexcept
    {
        return state.codes[table::index_of(column, index)];
    }
    template <typename Number>
    [[nodiscard]] Number number(Column column) const noexcept
    {
        return static_cast<Number>(code(column));
    }
    [[nodiscard]] Vector vector(Column x, Column y, Column z) const noexcept
    {
        return {Word::from_raw(code(x)), Word::from_raw(code(y)), Word::from_raw(code(z))};
    }
    [[nodiscard]] std::array<std::uint8_t, 3> colour(Column r, Column g, Column b) const noexcept
    {
        return {number<std::uint8_t>(r), number<std::uint8_t>(g), number<std::uint8_t>(b)};
    }
};

Sphere sphere_of(const Row<table::sphere::Column>& row) noexcept
{
    using namespace table::sphere; // NOLINT(google-build-using-namespace): its columns
    return make_sphere(row.vector(X, Y, Z), row.number<std::uint16_t>(RADIUS), row.colour(R, G, B),
                       row.number<Weight>(REFLECT));
}

Plane plane_of(const Row<table::plane::Column>& row) noexcept
{
    using namespace table::plane; // NOLINT(google-build-using-namespace): its columns
    return {.normal = row.vector(A, B, C),
            .offset = Word::from_raw(row.code(D)),
            .colour = ray_colour(row.colour(RED, GREEN, BLUE)),
            .checker = row.number<std::uint8_t>(CHECKER),
            .bounded = row.code(BOUNDED) != 0,
            .reflect = row.number<Weight>(REFLECT),
            .limits = {row.number<std::uint16_t>(XL), row.number<std::uint16_t>(YL),
                       row.number<std::uint16_t>(ZL)}};
}

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

Frame latch(std::span<const std::uint32_t> words) noexcept
{
    const protocol::State state = protocol::unpack(table::description, words);
    const auto word = [&](table::Index i) { return Word::from_raw(state.codes[i]); };

    Frame frame;
    frame.defects = Defects(static_cast<Profile>(state.codes[table::PROFILE]));
    frame.eye = {word(table::EX), word(table::EY), word(table::EZ)};
    frame.light = {word(table::LX), word(table::LY), word(table::LZ)};
    frame.screen = word(table::S);
    frame.reflections = static_cast<std::uint8_t>(state.codes[table::REFLECTIONS]);
    frame.anti_aliasing =
        static_cast<AntiAliasing>(std::min<std::int64_t>(state.codes[table::AA], 2));
    frame.planes_drawn = state.codes[table::PLANES] != 0;
    frame.last = static_cast<std::uint8_t>(
        std::clamp<std::int64_t>(state.codes[table::N], 1, max_spheres - 1));
    for (std::size_t i = 0; i < frame.last; ++i)
        frame.spheres[i] = sphere_of({state, i});
    frame.spheres[frame.last] =
        make_light(frame.light, static_cast<std::uint16_t>(state.codes[table::LR]));
    for (std::size_t i = 0; i < plane_count; ++i)
        frame.planes[i] = plane_of({state, i});
    return frame;
}

} // namespace raymarch::engine::whitted
