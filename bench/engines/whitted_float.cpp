// SPDX-License-Identifier: MIT
#include "engines/whitted_float.hpp"

#include "engine/whitted/frame.hpp"
#include "engine/whitted/ray_setup.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

namespace raymarch::bench
{
namespace
{

using engine::whitted::Frame;
using engine::whitted::Word;

struct Vector
{
    float x, y, z;

    [[nodiscard]] Vector plus(Vector v) const { return {x + v.x, y + v.y, z + v.z}; }
    [[nodiscard]] Vector minus(Vector v) const { return {x - v.x, y - v.y, z - v.z}; }
    [[nodiscard]] Vector times(float s) const { return {x * s, y * s, z * s}; }
    [[nodiscard]] float dot(Vector v) const { return x * v.x + y * v.y + z * v.z; }
    [[nodiscard]] float length() const { return std::sqrt(dot(*this)); }
};

float number(Word word)
{
    return static_cast<float>(word.raw()) / 4096;
}

Vector vector(const engine::whitted::Vector& v)
{
    return {number(v.x), number(v.y), number(v.z)};
}

/// Channels up to 1023.
Vector channels(const engine::whitted::Colour& c)
{
    return {static_cast<float>(c[0]), static_cast<float>(c[1]), static_cast<float>(c[2])};
}

struct Sphere
{
    Vector centre, colour;
    float squared_radius, inverse_radius, reflect;
};

struct Plane
{
    Vector normal, colour;
    float offset, reflect;
    int checker;
    bool bounded;
    std::array<float, 3> limits;
};

struct Scene
{
    Vector eye, light;
    std::vector<Sphere> spheres; ///< the light is the last
    std::vector<Plane> planes;
    unsigned reflections;
};

Scene scene_of(const Frame& frame)
{
    Scene scene{vector(frame.eye), vector(frame.light), {}, {}, frame.reflections};
    for (std::size_t i = 0; i <= frame.last; ++i) {
        const engine::whitted::Sphere& from = frame.spheres[i];
        const auto squared = static_cast<float>(from.squared_radius.raw() >> 24);
        scene.spheres.push_back({vector(from.centre), channels(from.colour), squared,
                                 1 / std::sqrt(squared), static_cast<float>(from.reflect) / 4096});
    }
    if (frame.planes_drawn)
        for (const engine::whitted::Plane& from : frame.planes) {
            Plane plane{vector(from.normal),
                        channels(from.colour),
                        number(from.offset),
                        static_cast<float>(from.reflect) / 4096,
                        from.checker,
                        from.bounded,
                        {}};
            std::copy(from.limits.begin(), from.limits.end(), plane.limits.begin());
            scene.planes.push_back(plane);
        }
    return scene;
}

struct Hit
{
    const Sphere* sphere = nullptr;
    const Plane* plane = nullptr;
    float distance = std::numeric_limits<float>::max();
};

/// Spheres, and planes where there is none: so does the hardware.
Hit nearest(const Scene& scene, Vector origin, Vector direction, const Sphere* leaves)
{
    Hit hit;
    for (const Sphere& sphere : scene.spheres) {
        const Vector way = sphere.centre.minus(origin);
        const float along = direction.dot(way);
        if (along < 0 || &sphere == leaves)
            continue;
        const float gap = way.dot(way) - sphere.squared_radius;
        const float chord = along * along - gap;
        if (chord < 0)
            continue;
        const float half = std::sqrt(chord);
        const float distance = gap < 0 ? along + half : along - half;
        if (distance > 0 && distance < hit.distance)
            hit = {&sphere, nullptr, distance};
    }
    if (hit.sphere != nullptr)
        return hit;
    for (const Plane& plane : scene.planes) {
        const float speed = direction.dot(plane.normal);
        if (speed >= 0)
            continue;
        const float distance = -(origin.dot(plane.normal) + plane.offset) / speed;
        if (distance <= 0.25F || distance >= hit.distance)
            continue;
        const Vector p = origin.plus(direction.times(distance));
        if (!plane.bounded || (std::abs(p.x) < plane.limits[0] && std::abs(p.y) < plane.limits[1] &&
                               std::abs(p.z) < plane.limits[2]))
            hit = {nullptr, &plane, distance};
    }
    return hit;
}

bool in_shadow(const Scene& scene, Vector point, Vector direction, float distance,
               const Sphere* own)
{
    for (const Sphere& sphere : scene.spheres) {
        if (&sphere == own || &sphere == &scene.spheres.back())
            continue;
        const Vector way = sphere.centre.minus(point);
        const float along = direction.dot(way);
        const float chord = along * along - way.dot(way) + sphere.squared_radius;
        if (along >= 0 && chord >= 0 && along - std::sqrt(chord) < distance)
            return true;
    }
    return false;
}

Vector colour_at(const Plane& plane, Vector p)
{
    const int squares = static_cast<int>(std::floor(p.x)) ^ static_cast<int>(std::floor(p.z));
    return plane.colour.times((squares & plane.checker) != 0 ? 0.25F : 1.0F);
}

struct Sample
{
    Vector colour{};
    bool sees_light = false;
};

Sample trace(const Scene& scene, Vector direction, std::uint64_t& rays)
{
    Sample sample;
    Vector origin = scene.eye;
    const Sphere* leaves = nullptr;
    float weight = 1;
    ++rays;
    for (unsigned reflections = 0;; ++reflections) {
        const Hit hit = nearest(scene, origin, direction, leaves);
        if (hit.sphere == nullptr && hit.plane == nullptr)
            return sample;
        if (hit.sphere == &scene.spheres.back()) {
            sample.colour = sample.colour.plus(hit.sphere->colour.times(weight));
            sample.sees_light = reflections == 0;
            return sample;
        }
        const Vector point = origin.plus(direction.times(hit.distance));
        const Vector normal =
            hit.sphere != nullptr
                ? point.minus(hit.sphere->centre).times(hit.sphere->inverse_radius)
                : hit.plane->normal;
        const Vector way = scene.light.minus(point);
        const float distance = way.length();
        const Vector to_light = way.times(1 / distance);
        const float cosine = hit.sphere != nullptr ? to_light.dot(normal) : 0.5F;
        const Vector colour =
            hit.sphere != nullptr ? hit.sphere->colour : colour_at(*hit.plane, point);
        ++rays;
        const bool dark = cosine < 0 || in_shadow(scene, point, to_light, distance, hit.sphere);
        sample.colour = sample.colour.plus(colour.times(weight * (dark ? 0.5F : 0.5F + cosine)));

        weight *= hit.sphere != nullptr ? hit.sphere->reflect : hit.plane->reflect;
        if (reflections == scene.reflections || weight < 0.01F)
            return sample;
        direction = direction.minus(normal.times(2 * direction.dot(normal)));
        direction = direction.times(1 / direction.length());
        origin = point;
        leaves = hit.sphere;
        ++rays;
    }
}

std::uint8_t byte(float channel, bool light)
{
    const auto five_bits = static_cast<unsigned>(std::min(channel, 1023.0F)) >> 5;
    return static_cast<std::uint8_t>(five_bits << 3 | (light ? 7U : 0U));
}

} // namespace

std::uint64_t draw_whitted_float(engine::WordSpan words, engine::PictureSize size,
                                 const engine::Canvas& canvas)
{
    const Frame frame = engine::whitted::latch(words);
    const Scene scene = scene_of(frame);
    const auto places = engine::whitted::sample_places(frame.anti_aliasing);
    const float depth = number(frame.screen) - scene.eye.z / 32;
    std::uint64_t rays = 0;
    std::uint8_t* to = canvas.rgb.data();
    for (unsigned y = 0; y < size.height; ++y)
        for (unsigned x = 0; x < size.width; ++x) {
            Vector sum{};
            bool light = false;
            for (const auto& place : places) {
                const auto across = [](unsigned pixel, int half, unsigned pixels, float eye) {
                    return (static_cast<float>(pixel) + static_cast<float>(half) / 2 -
                            static_cast<float>(pixels) / 2 - eye) /
                           32;
                };
                const Vector to_screen{across(x, place.dx, size.width, scene.eye.x),
                                       across(y, place.dy, size.height, scene.eye.y), depth};
                const Sample sample = trace(scene, to_screen.times(1 / to_screen.length()), rays);
                const float share = 1.0F / static_cast<float>(1 << place.shift);
                sum = sum.plus({std::min(sample.colour.x, 1023.0F) * share,
                                std::min(sample.colour.y, 1023.0F) * share,
                                std::min(sample.colour.z, 1023.0F) * share});
                light = light || (&place == places.data() && sample.sees_light);
            }
            *to++ = byte(sum.x, light);
            *to++ = byte(sum.y, light);
            *to++ = byte(sum.z, light);
        }
    return rays;
}

} // namespace raymarch::bench
