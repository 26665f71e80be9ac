// SPDX-License-Identifier: MIT
#include "engine/marcher/surface_vectors.hpp"

#include "engine/marcher/inverse_sqrt.hpp"

#include <array>

namespace raymarch::engine::marcher
{
namespace
{

/// The corners, as signs.
struct Corner
{
    int x, y, z;
};
constexpr std::array corners = {Corner{1, -1, -1}, Corner{-1, -1, 1}, Corner{-1, 1, -1},
                                Corner{1, 1, 1}};

Coordinate signed_by(int sign, Coordinate c) noexcept
{
    return sign < 0 ? -c : c;
}

} // namespace

Point surface_normal(const Point& p, Distance distance) noexcept
{
    Point gradient;
    for (const Corner& corner : corners) {
        const auto along = [&](Coordinate c) {
            return Point{signed_by(corner.x, c), signed_by(corner.y, c), signed_by(corner.z, c)};
        };
        gradient = gradient + along(distance(p + along(normal_step)));
    }
    return normalise(raw(gradient));
}

Point light_direction(const Point& p, const Point& light) noexcept
{
    return normalise(raw(light - p));
}

} // namespace raymarch::engine::marcher
