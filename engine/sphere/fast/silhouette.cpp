// SPDX-License-Identifier: MIT
#include "engine/sphere/fast/silhouette.hpp"

#include "engine/sphere/wide.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace raymarch::engine::sphere::fast
{
namespace
{

/// A quarter of the discriminant along a row, u columns from the eye:
///     (mx u + h)^2 - (u^2 + k) c = alpha u^2 + 2 beta u + gamma.
struct Row
{
    std::int64_t mx;
    std::int64_t h;
    std::int64_t k;
    std::int64_t c;

    [[nodiscard]] std::int64_t alpha() const noexcept { return mx * mx - c; }
    [[nodiscard]] std::int64_t beta() const noexcept { return mx * h; }
    [[nodiscard]] double gamma() const noexcept
    {
        return static_cast<double>(h) * static_cast<double>(h) -
               static_cast<double>(k) * static_cast<double>(c);
    }
    [[nodiscard]] std::int64_t a(std::int64_t u) const noexcept { return u * u + k; }
    [[nodiscard]] std::int64_t half_b(std::int64_t u) const noexcept { return mx * u + h; }
    /// Exactly.
    [[nodiscard]] bool misses(std::int64_t u) const noexcept
    {
        return (product(half_b(u), half_b(u)) - product(a(u), c)).is_negative();
    }
    /// How the discriminant grows there.
    [[nodiscard]] std::int64_t slope(std::int64_t u) const noexcept { return alpha() * u + beta(); }
    /// True if coefficients keep their value in 32 bits; they are largest at the ends of a span.
    [[nodiscard]] bool fits_32_bits(std::int64_t u) const noexcept
    {
        constexpr std::int64_t limit = std::numeric_limits<std::int32_t>::max();
        return a(u) <= limit && 2 * std::abs(half_b(u)) <= limit && std::abs(c) <= limit;
    }
};

constexpr double farthest = 1 << 18; ///< beyond every column

std::int64_t column(double u) noexcept
{
    return static_cast<std::int64_t>(std::clamp(u, -farthest, farthest));
}

} // namespace

Span silhouette(const Rules& rules, const Frame& frame, const Ball& ball, std::int32_t y,
                Span of) noexcept
{
    const auto difference = [](std::int32_t a, std::int32_t b) { return std::int64_t{a} - b; };
    const std::int64_t mx = difference(frame.eye.x, ball.centre.x);
    const std::int64_t my = difference(frame.eye.y, ball.centre.y);
    const std::int64_t mz = difference(frame.eye.z, ball.centre.z);
    const std::int64_t dy = difference(y, frame.eye.y);
    const std::int64_t dz = difference(frame.screen, frame.eye.z);
    const Row row{.mx = mx,
                  .h = dy * my + dz * mz,
                  .k = dy * dy + dz * dz,
                  .c = mx * mx + my * my + mz * mz - std::int64_t{ball.radius} * ball.radius};
    const std::int64_t eye = frame.eye.x;
    if (rules.narrow_coefficients &&
        (!row.fits_32_bits(of.first - eye) || !row.fits_32_bits(of.end - 1 - eye)))
        return of;
    if (row.alpha() >= 0)
        return of; // seen from all around, or from between its poles

    // The parabola is open downwards. Its roots are a guess, which need not be right: a column that
    // misses on the rising side has only misses before it, one on the falling side only misses
    // behind it, and both is looked at in integers.
    const auto alpha = static_cast<double>(row.alpha());
    const auto beta = static_cast<double>(row.beta());
    const double top = -beta / alpha;
    const double reach = std::sqrt(std::max(0.0, beta * beta - alpha * row.gamma())) / -alpha;
    const std::int64_t before = column(std::floor(top - reach)) - 1;
    const std::int64_t behind = column(std::ceil(top + reach)) + 1;
    Span seen = of;
    if (row.misses(before) && row.slope(before) >= 0)
        seen.first =
            static_cast<std::int32_t>(std::clamp<std::int64_t>(before + 1 + eye, of.first, of.end));
    if (row.misses(behind) && row.slope(behind) <= 0)
        seen.end =
            static_cast<std::int32_t>(std::clamp<std::int64_t>(behind + eye, seen.first, of.end));
    return seen;
}

} // namespace raymarch::engine::sphere::fast
