// SPDX-License-Identifier: MIT
#include "engine/marcher/scene_query.hpp"

#include "engine/marcher/inverse_sqrt.hpp"

#include <algorithm>
#include <array>

namespace raymarch::engine::marcher
{
namespace
{

constexpr Coordinate one = ratio(1, 1);
constexpr Coordinate half = ratio(1, 2);
constexpr Coordinate quarter = ratio(1, 4);

constexpr std::array scenes = {
    SceneRow{Scene::Sphere, sphere, 5},
    SceneRow{Scene::Cube, cube, 1},
    SceneRow{Scene::InfiniteCube, infinite_cube, 2},
    SceneRow{Scene::Tunnel, tunnel, 8},
};

/// Returns where `c` stands in its cell of `2 * middle` units, measured from the middle of the
/// cell.
Coordinate fold(Coordinate c, Coordinate middle) noexcept
{
    const std::int32_t mask = 2 * middle.raw() - 1; // cells are powers of two
    return Coordinate::from_raw((c.raw() & mask) - middle.raw());
}

Coordinate largest(const Point& p) noexcept
{
    return std::max({p.x, p.y, p.z});
}

/// The middle one of three values: the distance from the nearest of three square bars.
Coordinate median(const Point& p) noexcept
{
    return std::max(std::min(p.x, p.y), std::min(std::max(p.x, p.y), p.z));
}

/// One generation of the sponge: cells of 2 * middle units, bars of half width `bar`.
struct Generation
{
    Coordinate middle;
    Coordinate bar;
};
constexpr std::array generations = {
    Generation{ratio(1, 1), ratio(45, 100)},
    Generation{ratio(1, 2), ratio(28'333, 100'000)},
    Generation{ratio(1, 4), ratio(18'167, 100'000)},
    Generation{ratio(1, 16), ratio(5, 100)},
};

Coordinate distance_from_bars(const Point& p, const Generation& generation) noexcept
{
    const auto folded = [&](Coordinate c) { return absolute(fold(c, generation.middle)); };
    return median(map(p, folded)) - generation.bar;
}

} // namespace

Coordinate sphere(const Point& p) noexcept
{
    return length(p) - one;
}

Coordinate cube(const Point& p) noexcept
{
    return largest(map(p, absolute)) - half;
}

Coordinate infinite_cube(const Point& p) noexcept
{
    const auto folded = [](Coordinate c) { return absolute(fold(c + half, half)); };
    return largest(map(p, folded)) - quarter;
}

Coordinate tunnel(const Point& p) noexcept
{
    Coordinate distance = distance_from_bars(p, generations[0]);
    for (std::size_t i = 1; i < generations.size(); ++i)
        distance = std::max(distance, distance_from_bars(p, generations[i]));
    return distance;
}

const SceneRow& scene_row(Scene scene) noexcept
{
    return scenes[static_cast<std::size_t>(scene) % scenes.size()];
}

} // namespace raymarch::engine::marcher
