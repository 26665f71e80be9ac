// SPDX-License-Identifier: MIT
#include "engine/sphere/ray_sphere_unit.hpp"

#include "engine/sphere/root.hpp"

#include <algorithm>
#include <array>

namespace raymarch::engine::sphere
{
namespace
{

constexpr std::int64_t largest_coordinate = (1 << 17) - 1;

// Laid out by hand: one row a rule, one column a set of rules.
// clang-format off
constexpr Rules rtl = {
    .strict = true, .root = floor_root, .narrow_coefficients = false,
    .unsigned_threshold = true, .far_root_in_x = true, .root_by_root = false,
    .narrowing = Narrowing::Low16};
constexpr Rules rtl_repaired = {
    .strict = true, .root = floor_root, .narrow_coefficients = false,
    .unsigned_threshold = false, .far_root_in_x = false, .root_by_root = false,
    .narrowing = Narrowing::Low16};
constexpr Rules prototype = {
    .strict = false, .root = rounded_root, .narrow_coefficients = true,
    .unsigned_threshold = false, .far_root_in_x = false, .root_by_root = false,
    .narrowing = Narrowing::Low32};
constexpr Rules corrected = {
    .strict = false, .root = floor_root, .narrow_coefficients = false,
    .unsigned_threshold = false, .far_root_in_x = false, .root_by_root = true,
    .narrowing = Narrowing::Saturate};
// clang-format on

/// The prototype's arithmetic wraps on inputs beyond its range. Unsigned numbers do so without
/// being undefined, and where nothing wraps they are the same.
using Wrapping = Vec3<std::uint64_t>;

Wrapping wrapping(const Point& p) noexcept
{
    return map(p, [](std::int32_t c) { return static_cast<std::uint64_t>(std::int64_t{c}); });
}

std::uint64_t dot(const Wrapping& a, const Wrapping& b) noexcept
{
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

/// a t^2 + b t + c = 0 at the sphere.
struct Quadratic
{
    std::int64_t a;
    std::int64_t b;
    std::int64_t c;
};

Quadratic quadratic(const Rules& rules, const Line& line, const Ball& ball) noexcept
{
    const Wrapping from = wrapping(line.from);
    const Wrapping along = wrapping(line.to) - from;
    const Wrapping beside = from - wrapping(ball.centre);
    const auto radius = static_cast<std::uint64_t>(std::int64_t{ball.radius});
    const auto cut = [&](std::uint64_t value) {
        return rules.narrow_coefficients ? static_cast<std::int32_t>(value)
                                         : static_cast<std::int64_t>(value);
    };
    return {cut(dot(along, along)), cut(2 * dot(along, beside)),
            cut(dot(beside, beside) - radius * radius)};
}

/// Says whether a root lies before the reach.
bool before(const Rules& rules, std::int64_t root, std::int64_t threshold) noexcept
{
    return rules.unsigned_threshold
               ? static_cast<std::uint64_t>(root) < static_cast<std::uint64_t>(threshold)
               : root < threshold;
}

std::int32_t narrowed(Narrowing narrowing, std::int64_t value) noexcept
{
    switch (narrowing) {
    case Narrowing::Low16:
        return static_cast<std::uint16_t>(value);
    case Narrowing::Low32:
        return static_cast<std::int32_t>(value);
    case Narrowing::Saturate:
        break;
    }
    return static_cast<std::int32_t>(
        std::clamp(value, -largest_coordinate - 1, largest_coordinate));
}

/// (first * to + (whole - root) * from) / whole, towards zero; `first` is the root where the
/// source has no slip.
std::int32_t along_axis(Narrowing narrowing, std::int64_t first, std::int64_t root,
                        std::int64_t whole, std::int32_t from, std::int32_t to) noexcept
{
    const auto bits = [](std::int64_t value) { return static_cast<std::uint64_t>(value); };
    const std::uint64_t sum = bits(first) * bits(to) + bits(whole - root) * bits(from);
    return narrowed(narrowing, static_cast<std::int64_t>(sum) / whole);
}

} // namespace

const Rules& rules_of(Design design, Faults faults) noexcept
{
    if (faults == Faults::Corrected)
        return corrected;
    if (design == Design::Prototype)
        return prototype;
    return faults == Faults::Kept ? rtl : rtl_repaired;
}

Strike intersect(const Rules& rules, const Line& line, const Ball& ball, Reach reach,
                 std::int32_t derounder) noexcept
{
    const auto [a, b, c] = quadratic(rules, line, ball);
    const Wide discriminant = product(b, b) - product(2 * a, 2 * c);
    if (discriminant.is_negative() || (rules.strict && discriminant == Wide{}))
        return {.end = End::Misses};

    const auto root = static_cast<std::int64_t>(rules.root(discriminant));
    const std::int64_t shift = derounder == 0 ? 0 : a / derounder;
    const std::int64_t far = -b + root - shift;
    const std::int64_t near = -b - root - shift;
    const std::int64_t whole = 2 * a; // T at t = 1
    const std::int64_t threshold = reach == Reach::Segment ? segment_threshold : 0;
    const auto too_near = [&](std::int64_t t) { return before(rules, t, threshold); };
    const auto too_far = [&](std::int64_t t) { return reach == Reach::Segment && t > whole; };
    if (a == 0)
        return {.end = End::Rejected};

    std::int64_t used = near;
    if (rules.root_by_root) {
        const auto within = [&](std::int64_t t) { return !too_near(t) && !too_far(t); };
        if (!within(near) && !within(far))
            return {.end = End::Rejected};
        used = within(near) ? near : far;
    } else if ((too_near(far) && too_near(near)) || (too_far(far) && too_far(near))) {
        return {.end = End::Rejected};
    }

    const auto axis = [&](std::int64_t first, std::int32_t from, std::int32_t to) {
        return along_axis(rules.narrowing, first, used, whole, from, to);
    };
    return {.end = End::Hits,
            .root = used,
            .point = {axis(rules.far_root_in_x ? far : used, line.from.x, line.to.x),
                      axis(used, line.from.y, line.to.y), axis(used, line.from.z, line.to.z)}};
}

} // namespace raymarch::engine::sphere
