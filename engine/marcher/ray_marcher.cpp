// SPDX-License-Identifier: MIT
#include "engine/marcher/ray_marcher.hpp"

namespace raymarch::engine::marcher
{

March march(const Point& origin, const Point& direction, Distance distance) noexcept
{
    March ray;
    Coordinate t;
    for (;;) {
        ray.point = origin + map(direction, [&](Coordinate c) { return multiply(c, t); });
        const Coordinate d = distance(ray.point);
        ++ray.queries;
        t = t + d;
        if (t > max_distance || ray.queries >= max_steps)
            return ray;
        if (d < surface_distance) {
            ray.hit = true;
            return ray;
        }
    }
}

} // namespace raymarch::engine::marcher
