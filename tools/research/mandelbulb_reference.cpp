// SPDX-License-Identifier: MIT
#include "tools/research/mandelbulb_reference.hpp"

#include "engine/mandelbulb/colouring.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace raymarch::tools
{
namespace
{

using namespace engine::mandelbulb;

template <typename Real>
using Vector = engine::Vec3<Real>;

/// Every quotient is computed in Real, so the camera is rounded to a number of Real.
template <typename Real, typename Integer>
Vector<Real> to_real(const engine::Vec3<Integer>& v, int fraction_bits) noexcept
{
    const auto component = [&](Int128 code) {
        const auto upper = static_cast<std::int64_t>(code >> 32);
        const auto lower = static_cast<std::uint32_t>(static_cast<std::uint64_t>(code));
        const long double value =
            std::ldexp(static_cast<long double>(upper), 32) + static_cast<long double>(lower);
        return static_cast<Real>(std::ldexp(value, -fraction_bits));
    };
    return map(v, [&](Integer code) { return component(Int128(code)); });
}

template <typename Real>
Real dot(const Vector<Real>& a, const Vector<Real>& b) noexcept
{
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

template <typename Real>
Vector<Real> scaled(const Vector<Real>& v, Real by) noexcept
{
    return map(v, [by](Real component) { return component * by; });
}

template <typename Real>
Vector<Real> direction_of(const Frame& frame, engine::PictureSize size, std::uint16_t x,
                          std::uint16_t y) noexcept
{
    const int width = size.width;
    const int height = size.height;
    int u = 2 * x + 1 - width;
    if (frame.aspect == Aspect::Square)
        u = u * height / width;
    const int v = height - 1 - 2 * y;
    const Vector<Real> q =
        scaled(to_real<Real>(frame.right, direction_bits), static_cast<Real>(u)) +
        scaled(to_real<Real>(frame.up, direction_bits), static_cast<Real>(v)) +
        scaled(to_real<Real>(frame.forward, direction_bits), static_cast<Real>(2 * height));
    const Real length = std::sqrt(dot(q, q));
    return length > 0 ? scaled(q, 1 / length) : q;
}

template <typename Real>
struct RealEstimate
{
    Real distance = 0;
    int index = 0;
};

template <typename Real>
RealEstimate<Real> estimate_real(const Vector<Real>& c, const Arithmetic& with,
                                 ThetaBy theta_by) noexcept
{
    // The hardware's radius is a multiple of 1/16.
    const Real escape = static_cast<Real>(escape_radius<Q57<Int128>>(with.power) >> 53) / 16;
    const auto d = static_cast<Real>(with.power);
    Vector<Real> w = c;
    Real dr = 1;
    int index = 0;
    for (;;) {
        const Real r = std::sqrt(dot(w, w));
        if (r > escape || index == with.iterations - 1)
            return {r > 1 ? std::log(r) * r / (2 * dr) : 0, index};
        const Real theta = r == 0                      ? 0
                           : theta_by == ThetaBy::Acos ? std::acos(w.z / r)
                                                       : std::atan2(std::hypot(w.x, w.y), w.z);
        const Real phi = std::atan2(w.y, w.x);
        const Real power = std::pow(r, d - 1);
        dr = d * power * dr + 1;
        const Real q = power * r;
        w = Vector<Real>{q * std::sin(d * theta) * std::cos(d * phi),
                         q * std::sin(d * theta) * std::sin(d * phi), q * std::cos(d * theta)} +
            c;
        ++index;
    }
}

template <typename Real>
ReferenceRay<Real> march_real(const Frame& frame, const Vector<Real>& origin,
                              const Vector<Real>& direction, ThetaBy theta) noexcept
{
    constexpr Real farthest_real = 8;
    ReferenceRay<Real> ray;
    Real epsilon = 0;
    while (ray.evaluations < frame.max_evaluations) {
        const auto [distance, index] =
            estimate_real(origin + scaled(direction, ray.t), frame.arithmetic, theta);
        if (ray.evaluations == 0)
            epsilon = std::ldexp(distance, -frame.epsilon_shift);
        ++ray.evaluations;
        ray.index = index;
        ray.t += distance;
        if (distance <= epsilon) {
            ray.outcome = Outcome::Hit;
            break;
        }
        if (ray.t > farthest_real) {
            ray.outcome = Outcome::Miss;
            break;
        }
    }
    return ray;
}

} // namespace

template <typename Real>
ReferenceRay<Real> march_reference(const Frame& frame, engine::PictureSize size, std::uint16_t x,
                                   std::uint16_t y, ThetaBy theta) noexcept
{
    return march_real(frame, to_real<Real>(frame.position, position_bits),
                      direction_of<Real>(frame, size, x, y), theta);
}

template <typename Real>
void draw_reference_row(const Frame& frame, engine::RowOf row, std::span<std::uint8_t> pixels,
                        std::span<engine::PixelCost> costs, ThetaBy theta) noexcept
{
    for (unsigned at = row.columns.first; at < row.end(); at += row.columns.step) {
        const auto x = static_cast<std::uint16_t>(at);
        const ReferenceRay<Real> ray = march_reference<Real>(frame, row.size, x, row.y, theta);
        costs[x] = {.steps = static_cast<std::uint32_t>(ray.evaluations), .rays = 1};
        const Rgb colour = ray.outcome == Outcome::Miss
                               ? step_colours[0]
                               : colour_of(frame.colour, ray.evaluations, ray.index);
        std::uint8_t* const pixel = pixels.data() + std::size_t{3} * x;
        pixel[0] = static_cast<std::uint8_t>(colour >> 16);
        pixel[1] = static_cast<std::uint8_t>(colour >> 8);
        pixel[2] = static_cast<std::uint8_t>(colour);
    }
}

// The header declares these three instances.
// clang-format off
template ReferenceRay<float> march_reference(const Frame&, engine::PictureSize, std::uint16_t, std::uint16_t, ThetaBy) noexcept;
template ReferenceRay<double> march_reference(const Frame&, engine::PictureSize, std::uint16_t, std::uint16_t, ThetaBy) noexcept;
template ReferenceRay<long double> march_reference(const Frame&, engine::PictureSize, std::uint16_t, std::uint16_t, ThetaBy) noexcept;
template void draw_reference_row<float>(const Frame&, engine::RowOf, std::span<std::uint8_t>, std::span<engine::PixelCost>, ThetaBy) noexcept;
template void draw_reference_row<double>(const Frame&, engine::RowOf, std::span<std::uint8_t>, std::span<engine::PixelCost>, ThetaBy) noexcept;
template void draw_reference_row<long double>(const Frame&, engine::RowOf, std::span<std::uint8_t>, std::span<engine::PixelCost>, ThetaBy) noexcept;
// clang-format on

} // namespace raymarch::tools
