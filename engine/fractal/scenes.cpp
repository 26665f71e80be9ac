// SPDX-License-Identifier: MIT
#include "engine/fractal/scenes.hpp"

#include <array>

namespace raymarch::engine::fractal
{
namespace
{

constexpr std::array scenes = {
    SceneRow{Scene::Menger, menger, 4},
    SceneRow{Scene::Cubes, cubes, 1},
    SceneRow{Scene::Cube, cube, 1},
    SceneRow{Scene::Maze, maze, 5},
};

/// One generation of the sponge: which bits of a position stand in its cell, the middle of the
/// cell, and how far from the nearest bar's axis matter begins, negative.
struct Generation
{
    std::int32_t mask;
    Number middle;
    Number offset;
};
constexpr std::array generations = {
    // The hardware halves the position and doubles the fraction: the lowest bit is lost.
    Generation{0x1FFFE, one, word(-29492)},
    Generation{0x0FFFF, half, word(-18569)},
    Generation{0x07FFF, quarter, word(-11906)},
    Generation{0x01FFF, sixteenth, word(-3277)},
};

Number distance_from_bars(const Point& p, const Generation& generation) noexcept
{
    const auto folded = [&](Number c) {
        return absolute(word(c.raw() & generation.mask) - generation.middle);
    };
    return middle(map(p, folded)) + generation.offset;
}

/// Half a cell from the middle of the cell to the face that `q` is nearest to; 0 along an axis that
/// another one outweighs. Ties go to several axes.
Number towards_face(Number q, Number nearest) noexcept
{
    if (q == Number{} || absolute(q) < nearest)
        return Number{};
    return q < Number{} ? -half : half;
}

} // namespace

Number menger(const Point& p) noexcept
{
    Number distance = distance_from_bars(p, generations[0]);
    for (std::size_t i = 1; i < generations.size(); ++i)
        distance = std::max(distance, distance_from_bars(p, generations[i]));
    return distance;
}

Number cubes(const Point& p) noexcept
{
    const auto folded = [](Number c) { return absolute(fraction(c + half) - half); };
    return largest(map(p, folded)) - quarter;
}

Number cube(const Point& p) noexcept
{
    return largest(map(p, absolute)) - half;
}

Number maze(const Point& p) noexcept
{
    const Point q = map(p, [](Number c) { return fraction(c) - half; }); // from the cell's middle
    const Point a = map(q, absolute);
    const Number nearest = largest(a);
    const auto name = [&](Number c, Number from_middle) { // of the face, the same from both sides
        return floor(c) + half + towards_face(from_middle, nearest);
    };
    const Number hash =
        fraction(multiply(name(p.x, q.x), three_halves) +
                 (multiply(name(p.y, q.y), third) + multiply(name(p.z, q.z), quarter)));

    // The hash chooses along which axis the cell's bar runs.
    const Number across = hash <= third  ? std::max(a.x, a.y)
                          : hash <= half ? std::max(a.y, a.z)
                                         : std::max(a.x, a.z);
    return across - sixteenth;
}

const SceneRow& scene_row(Scene scene) noexcept
{
    return scenes[static_cast<std::size_t>(scene) % scenes.size()];
}

} // namespace raymarch::engine::fractal
