// SPDX-License-Identifier: MIT
#include "engine/marcher/fast/outline.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace raymarch::engine::marcher::fast
{
namespace
{

/// How far the body is from the scene's surface: SURFACE_DIST, and 0.0056 units of margin.
constexpr double reach = 1.0 / 64;

// A basis that is thinner, or a camera that is closer, would magnify the roundings too much.
constexpr double least_volume = 1.0 / 8;
constexpr double least_depth = 1.0 / 16;
constexpr double least_curvature = 1.0 / 4;

using Vector = Vec3<double>;

double dot(const Vector& a, const Vector& b) noexcept
{
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

Vector cross(const Vector& a, const Vector& b) noexcept
{
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

/// The basis in units.
Vector units(const RawVector& v) noexcept
{
    return map(v, [](std::int32_t code) { return code / static_cast<double>(1 << 17); });
}

Vector units(const Point& p) noexcept
{
    return map(p, [](Coordinate c) { return c.raw() / static_cast<double>(1 << 24); });
}

double volume(const Frame& frame) noexcept
{
    return dot(cross(units(frame.right), units(frame.up)), units(frame.forward));
}

/// The pixels whose u = 2x + 1 - W lies between the two.
Span between(double left, double right, double width) noexcept
{
    const double first = std::ceil((left + width - 1) / 2);
    const double end = std::floor((right + width - 1) / 2) + 1;
    return {static_cast<int>(std::clamp(first, 0.0, width)),
            static_cast<int>(std::clamp(end, 0.0, width))};
}

double height_of(int y, PictureSize size) noexcept
{
    return size.height - 1 - 2 * y;
}

} // namespace

BallOutline::BallOutline(const Frame& frame, PictureSize size) noexcept : size_(size)
{
    const Vector eye = units(frame.eye);
    const Vector right = units(frame.right);
    const Vector up = units(frame.up);
    const Vector forward =
        map(units(frame.forward), [&](double component) { return component * size.height; });
    constexpr double radius = 1 + reach;
    horizon_ = dot(eye, eye) - radius * radius;
    eye_right_ = dot(eye, right);
    eye_up_ = dot(eye, up);
    eye_forward_ = dot(eye, forward);
    right_right_ = dot(right, right);
    right_up_ = dot(right, up);
    right_forward_ = dot(right, forward);
    up_up_ = dot(up, up);
    up_forward_ = dot(up, forward);
    forward_forward_ = dot(forward, forward);
    proved_ = std::abs(volume(frame)) >= least_volume && horizon_ > 0 &&
              horizon_ * right_right_ - eye_right_ * eye_right_ >= least_curvature;
    if (!proved_)
        return;

    // A hit is at most 0.15 beyond where the ray is closest to the middle, which is at most as far
    // as the eye is. A ray's square distance is largest at one of its ends.
    const double distance = std::sqrt(dot(eye, eye));
    const double far = distance + 0.25;
    const double at_far = dot(eye, eye) + far * far - 2 * far * std::sqrt(horizon_);
    constexpr double nearly_four_squared = 15.5;
    near_ = std::max(dot(eye, eye), at_far) < nearly_four_squared;
    if (near_)
        farthest_ = Coordinate::from_raw(static_cast<std::int64_t>(far * (1 << 24)));
}

Span BallOutline::of_row(int y) const noexcept
{
    if (!proved_)
        return {0, size_.width};
    // With d = start + u * R, the ray meets the ball where (E.d)^2 >= horizon * d^2 and E.d < 0:
    // where -curvature u^2 + 2 linear u + constant >= 0, between two roots.
    const double v = height_of(y, size_);
    const double eye_start = v * eye_up_ - eye_forward_;
    const double right_start = v * right_up_ - right_forward_;
    const double start_start = v * v * up_up_ - 2 * v * up_forward_ + forward_forward_;
    const double curvature = horizon_ * right_right_ - eye_right_ * eye_right_;
    const double linear = eye_start * eye_right_ - horizon_ * right_start;
    const double constant = eye_start * eye_start - horizon_ * start_start;
    const double middle = linear / curvature;
    const double height = constant + linear * middle;
    if (height < 0 || eye_start + middle * eye_right_ > 0)
        return {0, 0};
    const double half = std::sqrt(height / curvature);
    return between(middle - half, middle + half, size_.width);
}

BoxOutline::BoxOutline(const Frame& frame, PictureSize size) noexcept : size_(size)
{
    const Vector eye = units(frame.eye);
    const Vector right = units(frame.right);
    const Vector up = units(frame.up);
    const Vector forward = units(frame.forward);
    const double basis = -volume(frame);
    proved_ = std::abs(basis) >= least_volume;
    if (!proved_)
        return;

    struct Corner
    {
        double u, v;
    };
    std::array<Corner, 8> corners{};
    constexpr double half_width = 0.5 + reach;
    for (unsigned i = 0; i < corners.size(); ++i) {
        const auto side = [&](unsigned bit) { return (i & bit) != 0 ? half_width : -half_width; };
        const Vector from_eye = Vector{side(1), side(2), side(4)} - eye;
        // from_eye = depth/f * (u R + v U - f F), by Cramer's rule.
        const double depth = dot(cross(right, up), from_eye) / basis;
        if (depth < least_depth)
            proved_ = false;
        const double scale = size.height / (depth * basis);
        corners[i] = {-scale * dot(cross(from_eye, up), forward),
                      -scale * dot(cross(right, from_eye), forward)};
    }

    std::size_t edge = 0;
    for (unsigned i = 0; i < corners.size(); ++i)
        for (const unsigned bit : {1U, 2U, 4U})
            if ((i & bit) == 0) {
                const auto [low, high] = std::minmax(corners[i], corners[i | bit],
                                                     [](Corner a, Corner b) { return a.v < b.v; });
                const double rise = high.v - low.v;
                edges_[edge++] = {low.v, high.v, low.u, rise > 0 ? (high.u - low.u) / rise : 0};
            }
}

Span BoxOutline::of_row(int y) const noexcept
{
    if (!proved_)
        return {0, size_.width};
    const double v = height_of(y, size_);
    double left = std::numeric_limits<double>::max();
    double right = std::numeric_limits<double>::lowest();
    for (const Edge& edge : edges_)
        if (edge.bottom <= v && v <= edge.top) {
            const double u = edge.u + edge.slope * (v - edge.bottom);
            left = std::min(left, u);
            right = std::max(right, u);
        }
    return left > right ? Span{0, 0} : between(left, right, size_.width);
}

} // namespace raymarch::engine::marcher::fast
