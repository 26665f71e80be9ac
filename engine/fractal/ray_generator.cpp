// SPDX-License-Identifier: MIT
#include "engine/fractal/ray_generator.hpp"

#include "engine/fractal/inverse_sqrt.hpp"

namespace raymarch::engine::fractal
{
Camera camera_along(const Point& f) noexcept
{
    // multiply(f.y, -f.x) and -multiply(f.y, f.x) are floored to different sides.
    return {
        .forward = f,
        .right = {f.z, Number{}, -f.x},
        .up = {multiply(f.y, -f.x), multiply(f.z, f.z) + multiply(f.x, f.x), -multiply(f.y, f.z)}};
}

Plane plane_of(PictureSize size) noexcept
{
    const std::int32_t width = size.width;
    const std::int32_t height = size.height;
    const std::int64_t ratio = std::int64_t{width} * one.raw();
    return {.left = Number::from_raw(-((ratio + height - 1) / height)), // the floor of -W / H
            .top = -one,
            .step = word(2 * one.raw() / height)};
}

Number along(Number first, Number step, std::uint16_t count) noexcept
{
    // The sum of `count` steps; steps are at most 2.0 and counts 16 bits, so it needs 64.
    return Number::from_raw(first.raw() + std::int64_t{step.raw()} * count);
}

Point ray_direction(const Camera& camera, const Plane& plane, std::uint16_t x,
                    std::uint16_t y) noexcept
{
    const Number right = along(plane.left, plane.step, x);
    const Number up = along(plane.top, plane.step, y);
    const auto by = [](Number factor) {
        return [factor](Number c) { return multiply(c, factor); };
    };
    const Point v = map(camera.right, by(right)) + map(camera.up, by(up)) + camera.forward;
    const Number n = inverse_sqrt(multiply(v.x, v.x) + (multiply(v.y, v.y) + multiply(v.z, v.z)));
    // Up is up on the screen only from here on, and the sign comes behind the floor.
    return {multiply(v.x, n), -multiply(v.y, n), multiply(v.z, n)};
}

} // namespace raymarch::engine::fractal
