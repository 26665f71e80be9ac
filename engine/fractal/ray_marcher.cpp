// SPDX-License-Identifier: MIT
#include "engine/fractal/ray_marcher.hpp"

namespace raymarch::engine::fractal
{

March march(const Point& origin, const Point& direction, Distance distance) noexcept
{
    March ray{.point = origin};
    for (;;) {
        const Number s = distance(ray.point);
        ray.hit = s < hit_limit; // also at the last depth
        if (ray.hit || s > five || ray.depth == max_depth)
            return ray;
        ray.point = ray.point + map(direction, [&](Number c) { return multiply(c, s); });
        ++ray.depth;
    }
}

} // namespace raymarch::engine::fractal
