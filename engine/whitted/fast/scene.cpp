// SPDX-License-Identifier: MIT
#include "engine/whitted/fast/scene.hpp"

#include "engine/whitted/sphere_stage.hpp"

#include <algorithm>
#include <cmath>

namespace raymarch::engine::whitted::fast
{
namespace
{

double length_of(const Vector& v) noexcept
{
    return std::hypot(double(v.x.raw()), double(v.y.raw()), double(v.z.raw()));
}

std::int32_t low_half(Wide a) noexcept
{
    return static_cast<std::int32_t>(static_cast<std::uint32_t>(a.raw()));
}

float estimate(Wide a) noexcept
{
    return static_cast<float>(a.raw());
}

SphereColumns columns_of_spheres(const Frame& frame) noexcept
{
    SphereColumns to{};
    for (std::size_t i = 0; i <= frame.last; ++i) {
        const Sphere& sphere = frame.spheres[i];
        to.x[i] = sphere.centre.x.raw();
        to.y[i] = sphere.centre.y.raw();
        to.z[i] = sphere.centre.z.raw();
        to.x_[i] = static_cast<float>(to.x[i]);
        to.y_[i] = static_cast<float>(to.y[i]);
        to.z_[i] = static_cast<float>(to.z[i]);
        const double centre = length_of(sphere.centre);
        to.gap[i] =
            static_cast<float>(static_cast<double>(sphere.squared_radius.raw()) - centre * centre);
        to.squared_radius_[i] = estimate(sphere.squared_radius);
        to.radius_[i] = estimate(sphere.radius);
        to.squared_radius[i] = low_half(sphere.squared_radius);
        to.radius[i] = low_half(sphere.radius);
        to.inverse_radius[i] = sphere.inverse_radius.raw();
        to.offset_limit[i] =
            std::min(bounds::word_end - 1, bounds::normal_component * (1 << fraction_bits) /
                                               std::max(1, to.inverse_radius[i]));
        to.red[i] = sphere.colour[0];
        to.green[i] = sphere.colour[1];
        to.blue[i] = sphere.colour[2];
        to.reflect[i] = sphere.reflect;
    }
    return to;
}

PlaneColumns columns_of_planes(const Frame& frame) noexcept
{
    PlaneColumns to{};
    for (std::size_t i = 0; i < plane_count; ++i) {
        const Plane& plane = frame.planes[i];
        to.x[i] = plane.normal.x.raw();
        to.y[i] = plane.normal.y.raw();
        to.z[i] = plane.normal.z.raw();
        to.x_[i] = static_cast<float>(to.x[i]);
        to.y_[i] = static_cast<float>(to.y[i]);
        to.z_[i] = static_cast<float>(to.z[i]);
        to.offset[i] = plane.offset.raw();
        to.red[i] = plane.colour[0];
        to.green[i] = plane.colour[1];
        to.blue[i] = plane.colour[2];
        to.reflect[i] = plane.reflect;
        to.checker[i] = plane.checker;
    }
    return to;
}

/// The largest of the spheres; they decide how far points may be away.
struct Extent
{
    double centre = 0;     ///< the largest |centre|
    double coordinate = 0; ///< the largest of any of them
    double radius = 0;
};

Extent extent_of(const Frame& frame) noexcept
{
    Extent extent;
    for (std::size_t i = 0; i <= frame.last; ++i) {
        extent.centre = std::max(extent.centre, length_of(frame.spheres[i].centre));
        for (const Word c :
             {frame.spheres[i].centre.x, frame.spheres[i].centre.y, frame.spheres[i].centre.z})
            extent.coordinate = std::max(extent.coordinate, std::abs(double(c.raw())));
        extent.radius =
            std::max(extent.radius, std::sqrt(double(estimate(frame.spheres[i].squared_radius))));
    }
    return extent;
}

/// How far away a point may be so that its height above every plane is a word: of the height,
/// -point . normal - offset, the floor of the product takes up to 1.
double reach_of_planes(const Frame& frame) noexcept
{
    double reach = bounds::reach;
    if (frame.planes_drawn)
        for (const Plane& plane : frame.planes)
            reach =
                std::min(reach, (bounds::word_end - 2 - std::abs(double(plane.offset.raw()))) *
                                    (1 << fraction_bits) / std::max(1.0, length_of(plane.normal)));
    return reach;
}

bool is_tame(const Frame& frame, const Extent& extent) noexcept
{
    if (frame.planes_drawn)
        for (const Plane& plane : frame.planes)
            if (length_of(plane.normal) > bounds::plane_normal)
                return false;
    return reach_of_planes(frame) > 0 &&
           extent.radius <= double{bounds::radius} * (1 << fraction_bits) &&
           extent.centre < bounds::reach;
}

void set_bounds(Scene& scene, const Extent& extent) noexcept
{
    constexpr double rounding = 1 - 1.0 / (1 << 18); // of estimates that are held against them
    const double reach = std::min(bounds::reach - extent.centre, reach_of_planes(scene.frame));
    const double coordinate = bounds::word_end - 1 - extent.coordinate;
    const double near = std::min(reach, coordinate);
    scene.coordinate_bound = static_cast<std::int32_t>(coordinate);
    scene.squared_bound = static_cast<float>(reach * reach * rounding);
    scene.squared_near = static_cast<float>(near * near * rounding);
    constexpr double light_reach = 1024 * (1 << fraction_bits);
    scene.light_is_near = 2 * extent.centre + light_reach < bounds::reach_along;
}

bool eye_inside(const Frame& frame) noexcept
{
    return std::any_of(
        frame.spheres.begin(), frame.spheres.begin() + frame.last + 1,
        [&](const Sphere& sphere) { return approach(frame.eye, {}, sphere).from_inside; });
}

/// Twice the bounds that the page proves, and more.
Margins margins_of(const Extent& extent) noexcept
{
    const double centre = std::max(extent.centre, 4096.0);
    const double along = std::ldexp(1.0, -19);
    const double chord = std::ldexp(1.0, -18);
    return {.along = static_cast<float>(along * 1.5 * centre),
            .along_squared = static_cast<float>(along * 0.5 / centre),
            .chord = static_cast<float>(chord * (centre * centre + extent.radius * extent.radius)),
            .chord_squared = static_cast<float>(chord)};
}

} // namespace

Scene make_scene(const Frame& frame) noexcept
{
    Scene scene{.frame = frame};
    const Extent extent = extent_of(frame);
    if (!is_tame(frame, extent))
        return scene;
    set_bounds(scene, extent);
    const double eye = length_of(frame.eye);
    if (eye * eye >= double{scene.squared_near})
        return scene;
    scene.kind = eye_inside(frame) ? Scene::Kind::Black : Scene::Kind::Tame;
    scene.margins = margins_of(extent);
    scene.spheres = columns_of_spheres(frame);
    scene.planes = columns_of_planes(frame);
    return scene;
}

} // namespace raymarch::engine::whitted::fast
