// SPDX-License-Identifier: MIT
// Compiled once for each name of the function, RAYMARCH_STUDENT_DRAW.
#include "engines/student.hpp"

#include "engine/marcher/frame.hpp"

#include <algorithm>
#include <cmath>

namespace raymarch::bench
{
namespace
{

using engine::marcher::Frame;
using engine::marcher::Scene;

constexpr int max_steps = 100;
constexpr float max_distance = 20.0F;
constexpr float surface_distance = 0.01F;

struct Vector
{
    float x, y, z;

    [[nodiscard]] Vector plus(Vector v) const { return {x + v.x, y + v.y, z + v.z}; }
    [[nodiscard]] Vector times(float s) const { return {x * s, y * s, z * s}; }
    [[nodiscard]] float dot(Vector v) const { return x * v.x + y * v.y + z * v.z; }
    [[nodiscard]] float length() const { return std::sqrt(dot(*this)); }
    [[nodiscard]] Vector normalised() const { return times(1.0F / length()); }
};

float largest(Vector v)
{
    return std::max(std::max(v.x, v.y), v.z);
}

float median(Vector v)
{
    return std::max(std::min(v.x, v.y), std::min(std::max(v.x, v.y), v.z));
}

/// How far each coordinate is from the middle of its cell.
Vector folded(Vector p, float cell, float shift)
{
    const auto fold = [&](float c) {
        const float in_cell = c + shift - cell * std::floor((c + shift) / cell);
        return std::abs(in_cell - cell / 2);
    };
    return {fold(p.x), fold(p.y), fold(p.z)};
}

template <Scene scene>
float distance(Vector p)
{
    if constexpr (scene == Scene::Sphere)
        return p.length() - 1.0F;
    if constexpr (scene == Scene::Cube)
        return largest({std::abs(p.x), std::abs(p.y), std::abs(p.z)}) - 0.5F;
    if constexpr (scene == Scene::InfiniteCube)
        return largest(folded(p, 1.0F, 0.5F)) - 0.25F;
    const float coarse =
        std::max(median(folded(p, 2.0F, 0.0F)) - 0.45F, median(folded(p, 1.0F, 0.0F)) - 0.28333F);
    const float fine =
        std::max(median(folded(p, 0.5F, 0.0F)) - 0.18167F, median(folded(p, 0.125F, 0.0F)) - 0.05F);
    return std::max(coarse, fine);
}

template <Scene scene>
float raymarch(Vector origin, Vector direction)
{
    float travelled = 0.0F;
    for (int i = 0; i < max_steps; ++i) {
        const Vector p = origin.plus(direction.times(travelled));
        const float d = distance<scene>(p);
        travelled += d;
        if (travelled > max_distance || d < surface_distance)
            break;
    }
    return travelled;
}

template <Scene scene>
Vector surface_normal(Vector p)
{
    constexpr float h = 0.01F;
    Vector sum{};
    for (const Vector corner :
         {Vector{1, -1, -1}, Vector{-1, -1, 1}, Vector{-1, 1, -1}, Vector{1, 1, 1}})
        sum = sum.plus(corner.times(distance<scene>(p.plus(corner.times(h)))));
    return sum.normalised();
}

Vector basis(const engine::marcher::RawVector& v)
{
    constexpr float unit = 1.0F / (1 << 17);
    return {unit * static_cast<float>(v.x), unit * static_cast<float>(v.y),
            unit * static_cast<float>(v.z)};
}

Vector point(const engine::marcher::Point& p)
{
    constexpr float unit = 1.0F / (1 << 24);
    return {unit * static_cast<float>(p.x.raw()), unit * static_cast<float>(p.y.raw()),
            unit * static_cast<float>(p.z.raw())};
}

template <Scene scene>
void draw_scene(const Frame& frame, const engine::Region& region, const engine::Canvas& canvas)
{
    const Vector eye = point(frame.eye);
    const Vector light = point(frame.light);
    const auto width = static_cast<float>(region.size.width);
    const auto height = static_cast<float>(region.size.height);
    for (unsigned y = region.y; y < unsigned{region.y} + region.height; y += region.step)
        for (unsigned x = region.x; x < unsigned{region.x} + region.width; x += region.step) {
            const float px =
                (2.0F * ((static_cast<float>(x) + 0.5F) / width) - 1.0F) * (width / height);
            const float py = -(2.0F * ((static_cast<float>(y) + 0.5F) / height) - 1.0F);
            const Vector direction = basis(frame.right)
                                         .times(px)
                                         .plus(basis(frame.up).times(py))
                                         .plus(basis(frame.forward).times(-1.0F))
                                         .normalised();
            const float travelled = raymarch<scene>(eye, direction);
            const Vector p = eye.plus(direction.times(travelled));
            float brightness = 0.0F;
            if (travelled < max_distance) {
                const Vector normal = surface_normal<scene>(p);
                const Vector to_light = light.plus(p.times(-1.0F)).normalised();
                brightness = std::max(normal.dot(to_light), 0.0F);
            }
            std::uint8_t* const pixel =
                &canvas.rgb[engine::bytes_per_pixel * (std::size_t{y} * region.size.width + x)];
            for (std::size_t i = 0; i < engine::bytes_per_pixel; ++i)
                pixel[i] = static_cast<std::uint8_t>(
                    brightness * static_cast<float>(frame.colour[i]) * (255.0F / 1024.0F));
        }
}

} // namespace

void RAYMARCH_STUDENT_DRAW(const engine::Picture& picture, const engine::Region& region,
                           const engine::Canvas& canvas) noexcept
{
    const auto& frame = engine::frame_of<Frame>(picture);
    switch (frame.scene) {
    case Scene::Sphere:
        return draw_scene<Scene::Sphere>(frame, region, canvas);
    case Scene::Cube:
        return draw_scene<Scene::Cube>(frame, region, canvas);
    case Scene::InfiniteCube:
        return draw_scene<Scene::InfiniteCube>(frame, region, canvas);
    case Scene::Tunnel:
        return draw_scene<Scene::Tunnel>(frame, region, canvas);
    }
}

} // namespace raymarch::bench
