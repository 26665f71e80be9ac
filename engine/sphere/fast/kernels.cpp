// SPDX-License-Identifier: MIT
// The pixels of both designs in vectors, as rtl_pixel.cpp, prototype_pixel.cpp and sphere.cpp have
// them. Highway compiles this file once for each instruction set.
#include "engine/fast/kernels.hpp"

#include "engine/fast/targets.hpp"
#include "engine/sphere/fast/silhouette.hpp"
#include "engine/sphere/frame.hpp"
#include "engine/sphere/ray_sphere_unit.hpp"
#include "engine/sphere/rtl_pixel.hpp"
#include "engine/sphere/sphere.hpp"
#include "engine/sphere/timeline.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "engine/sphere/fast/kernels.cpp"
#include <hwy/foreach_target.h>
// Behind foreach_target.h. The plain C++ that Highway may end with is not used.
#include <hwy/highway.h>
#if HWY_TARGET != HWY_SCALAR && HWY_TARGET != HWY_EMU128 && HWY_HAVE_FLOAT64
#include "engine/sphere/fast/ray_sphere_unit-inl.hpp"

#include <algorithm>
#include <array>

HWY_BEFORE_NAMESPACE();
namespace raymarch::engine::sphere::fast::HWY_NAMESPACE
{

/// Pixels at columns first, first + step, … of a row: up to `count`, and as many as there are
/// lanes.
struct Place
{
    PictureSize size;
    unsigned first;
    unsigned y;
    unsigned step;
    std::size_t count;
};

/// The columns of a row in which each ball may be seen.
using Seen = std::array<Span, max_balls>;

/// All pixels of a region share these numbers.
struct Scene
{
    Frame frame; ///< held
    Points eye;
    std::array<Points, max_balls> eye_beside; ///< the eye from the balls' centres
    std::array<Vec<F64>, max_balls> eye_c;
};

HWY_INLINE Vec<F64> radius_squared(const Ball& ball)
{
    return Set<F64>(std::int64_t{ball.radius} * ball.radius);
}

HWY_INLINE Scene scene_of(const Frame& frame)
{
    Scene scene;
    scene.frame = frame;
    scene.eye = points(frame.eye);
    for (std::size_t i = 0; i < max_balls; ++i) {
        const Ball& ball = frame.balls[i];
        scene.eye_beside[i] = difference(scene.eye, points(ball.centre));
        scene.eye_c[i] =
            hn::Sub(dot(scene.eye_beside[i], scene.eye_beside[i]), radius_squared(ball));
    }
    return scene;
}

/// The line from a pixel's point to a light.
template <RuleSet rules>
HWY_INLINE Strikes towards(const Points& light, const Points& point, const Ball& ball,
                           std::int32_t derounder)
{
    const Points beside = difference(point, points(ball.centre));
    const Vec<F64> c = hn::Sub(dot(beside, beside), radius_squared(ball));
    return intersect<rules, Reach::Segment>(point, light, beside, c, derounder);
}

/// Pixels of a vector, as they leave a design: channels and costs as integers.
struct Shown
{
    std::array<Vec<F64>, bytes_per_pixel> colour;
    Vec<F64> steps;
    Vec<F64> rays;
    Mask<F64> exact;
};

/// rtl_pixel() and what draw_row() makes of it.
template <RuleSet rules>
HWY_INLINE Shown rtl_pixels(const Scene& scene, const Points& target)
{
    const Frame& frame = scene.frame;
    const auto period = [](Outcome outcome) { return Set<F64>(row_of(outcome).period); };
    const auto rays = [](Outcome outcome) { return Set<F64>(row_of(outcome).rays); };
    const Strikes strikes = intersect<rules, Reach::Ray>(scene.eye, target, scene.eye_beside[0],
                                                         scene.eye_c[0], frame.derounder);
    Shown shown;
    shown.exact = strikes.exact;
    shown.steps = hn::IfThenElse(strikes.misses, period(Outcome::Missed), period(Outcome::Behind));
    shown.rays = rays(Outcome::Missed);
    shown.colour.fill(Set<F64>(0));
    if (hn::AllFalse(F64(), strikes.hits))
        return shown;

    const Light& light = frame.lights[0];
    const Strikes way =
        towards<rules>(points(light.position), strikes.point, frame.balls[0], frame.derounder);
    const Vec<F64> power = Set<F64>(std::int64_t{light.strength} * frame.calibration);
    const auto at_light = hn::Eq(way.squared, Set<F64>(0));
    Vec<F64> lit = quotient(power, hn::IfThenElse(at_light, Set<F64>(1), way.squared));
    if constexpr (rules == RuleSet::Corrected)
        lit = hn::IfThenElse(at_light, Set<F64>(rtl_white), hn::Max(lit, Set<F64>(frame.shadow)));
    else
        lit = hn::IfThenElse(at_light, Set<F64>(0), lit);
    const Vec<F64> shadowed = Set<F64>(frame.shadow);
    const Vec<F64> value = hn::Min(hn::IfThenElse(way.hits, shadowed, lit), Set<F64>(rtl_white));
    const Vec<F64> steps = hn::IfThenElse(
        way.hits, period(Outcome::Shadowed),
        hn::IfThenElse(way.misses, period(Outcome::LitClear), period(Outcome::LitRejected)));

    shown.exact = hn::And(shown.exact, hn::Or(way.exact, hn::Not(strikes.hits)));
    shown.steps = hn::IfThenElse(strikes.hits, steps, shown.steps);
    shown.rays = hn::IfThenElse(strikes.hits, rays(Outcome::Shadowed), shown.rays);
    const Vec<F64> bright = hn::IfThenElseZero(strikes.hits, hn::Mul(value, Set<F64>(17)));
    shown.colour = {bright, bright, frame.tint == Tint::Grey ? bright : Set<F64>(0)};
    return shown;
}

/// The rays of a vector see these balls.
struct Sight
{
    Mask<F64> visible; ///< the rays that see one
    Vec<F64> ball;     ///< its index
    Points point;
};

/// Also takes from shown.exact the rays whose numbers are not.
template <RuleSet rules>
HWY_INLINE Sight look(const Scene& scene, const Points& target, const Seen& seen,
                      const Place& place, Shown& shown)
{
    const F64 d;
    const Frame& frame = scene.frame;
    constexpr bool nearest = rules == RuleSet::Corrected;
    Mask<F64> visible = hn::MaskFromVec(hn::Zero(d));
    Vec<F64> ball = hn::Zero(d);
    Vec<F64> root = hn::Zero(d);
    Points point = scene.eye;
    const auto first_column = static_cast<std::int32_t>(place.first);
    const auto last_column = static_cast<std::int32_t>(place.first + (lanes<F64> - 1) * place.step);
    for (std::size_t i = 0; i < frame.ball_count; ++i) {
        if (last_column < seen[i].first || first_column >= seen[i].end)
            continue;
        const Strikes strikes = intersect<rules, Reach::Ray>(scene.eye, target, scene.eye_beside[i],
                                                             scene.eye_c[i], frame.derounder);
        shown.exact = hn::And(shown.exact, strikes.exact);
        if (hn::AllFalse(d, strikes.hits))
            continue;
        const Mask<F64> first = hn::AndNot(visible, strikes.hits);
        const Mask<F64> nearer =
            nearest ? hn::Or(first, hn::And(strikes.hits, hn::Lt(strikes.root, root)))
                    : strikes.hits;
        ball =
            hn::IfThenElse(nearest ? nearer : first, Set<F64>(static_cast<std::int64_t>(i)), ball);
        root = hn::IfThenElse(nearer, strikes.root, root);
        point = {hn::IfThenElse(nearer, strikes.point.x, point.x),
                 hn::IfThenElse(nearer, strikes.point.y, point.y),
                 hn::IfThenElse(nearer, strikes.point.z, point.z)};
        visible = hn::Or(visible, strikes.hits);
    }
    return {visible, ball, point};
}

/// The light that the balls' points receive. Also counts the steps of the search for it.
template <RuleSet rules>
HWY_INLINE Vec<F64> received_light(const Frame& frame, const Sight& sight, Shown& shown)
{
    const F64 d;
    constexpr bool nearest = rules == RuleSet::Corrected;
    constexpr std::int64_t white = 255;
    Vec<F64> brightness = Set<F64>(0);
    for (std::size_t j = 0; j < frame.light_count; ++j) {
        const Light& light = frame.lights[j];
        Mask<F64> open = sight.visible;
        for (std::size_t i = 0; i < frame.ball_count; ++i) {
            const Strikes way = towards<rules>(points(light.position), sight.point, frame.balls[i],
                                               frame.derounder);
            shown.steps = hn::Add(shown.steps, hn::IfThenElseZero(open, Set<F64>(1)));
            shown.exact = hn::And(shown.exact, hn::Or(way.exact, hn::Not(open)));
            open = hn::AndNot(way.hits, open);
            if (hn::AllFalse(d, open))
                break;
        }
        const Points way = difference(points(light.position), sight.point);
        const Vec<F64> squared = dot(way, way);
        const std::int64_t product = std::int64_t{light.strength} * frame.calibration;
        const Vec<F64> power = Set<F64>(nearest ? product : static_cast<std::int32_t>(product));
        const auto at_light = hn::Eq(squared, Set<F64>(0));
        const Vec<F64> received =
            hn::IfThenElse(at_light, Set<F64>(nearest ? white : 0),
                           quotient(power, hn::IfThenElse(at_light, Set<F64>(1), squared)));
        const Vec<F64> sum = hn::Min(Set<F64>(white), hn::Add(brightness, received));
        const Vec<F64> byte = Set<F64>(256); // the low byte of it
        const Vec<F64> low = hn::Sub(sum, hn::Mul(byte, hn::Floor(hn::Mul(sum, Set<F64>(0x1p-8)))));
        brightness = hn::IfThenElse(open, low, brightness);
    }
    return brightness;
}

/// prototype_pixel().
template <RuleSet rules>
HWY_INLINE Shown prototype_pixels(const Scene& scene, const Points& target, const Seen& seen,
                                  const Place& place)
{
    const Frame& frame = scene.frame;
    Shown shown;
    shown.exact = hn::Not(hn::MaskFromVec(hn::Zero(F64())));
    shown.steps = Set<F64>(static_cast<std::int64_t>(frame.ball_count));
    shown.rays = Set<F64>(1);
    shown.colour.fill(Set<F64>(0));
    const Sight sight = look<rules>(scene, target, seen, place, shown);
    if (hn::AllFalse(F64(), sight.visible))
        return shown;

    const Vec<F64> brightness = received_light<rules>(frame, sight, shown);
    const Vec<F64> shadow = Set<F64>(frame.shadow);
    for (std::size_t i = 0; i < bytes_per_pixel; ++i) {
        const Vec<F64> own = hn::Max(brightness, shadow);
        const auto here = hn::Eq(sight.ball, Set<F64>(static_cast<std::int64_t>(i)));
        shown.colour[i] = hn::IfThenElseZero(sight.visible, hn::IfThenElse(here, own, shadow));
    }
    shown.rays = hn::IfThenElse(
        sight.visible, Set<F64>(1 + static_cast<std::int64_t>(frame.light_count)), shown.rays);
    return shown;
}

/// Pixels one by one, by the reference's own stages.
void draw_alone(const Frame& frame, const Place& place, const Canvas& canvas)
{
    const std::size_t row = std::size_t{place.y} * place.size.width;
    const auto y = static_cast<std::int32_t>(place.y);
    for (std::size_t i = 0; i < place.count; ++i) {
        const std::size_t column = place.first + i * place.step;
        const Pixel pixel = draw_pixel(frame, static_cast<std::int32_t>(column), y);
        std::copy(pixel.colour.begin(), pixel.colour.end(),
                  &canvas.rgb[bytes_per_pixel * (row + column)]);
        if (!canvas.costs.empty())
            canvas.costs[row + column] = pixel.cost;
    }
}

void put(const Shown& shown, const Place& place, const Canvas& canvas)
{
    const hn::Rebind<std::int32_t, F64> integers;
    const auto store = [&](Vec<F64> v) {
        HWY_ALIGN std::array<std::int32_t, lanes<F64>> to;
        hn::Store(hn::DemoteTo(integers, v), integers, to.data());
        return to;
    };
    const std::size_t row = std::size_t{place.y} * place.size.width + place.first;
    const auto weighed = [](Vec<F64> v, int weight) { return hn::Mul(v, Set<F64>(weight)); };
    const auto colours =
        store(hn::Add(shown.colour[0], hn::Add(weighed(shown.colour[1], 1 << 8),
                                               weighed(shown.colour[2], 1 << 16))));
    for (std::size_t i = 0; i < place.count; ++i) {
        std::uint8_t* const rgb = &canvas.rgb[bytes_per_pixel * (row + i * place.step)];
        for (std::size_t channel = 0; channel < bytes_per_pixel; ++channel)
            rgb[channel] = static_cast<std::uint8_t>(colours[i] >> 8 * channel);
    }
    if (canvas.costs.empty())
        return;
    const auto steps = store(shown.steps);
    const auto rays = store(shown.rays);
    for (std::size_t i = 0; i < place.count; ++i)
        canvas.costs[row + i * place.step] = {.steps = static_cast<std::uint32_t>(steps[i]),
                                              .rays = static_cast<std::uint32_t>(rays[i])};
}

/// Pixels that hit nothing.
void put_nothing(const Place& place, PixelCost cost, const Canvas& canvas)
{
    const std::size_t row = std::size_t{place.y} * place.size.width + place.first;
    if (place.step == 1)
        std::fill_n(canvas.rgb.begin() + static_cast<std::ptrdiff_t>(bytes_per_pixel * row),
                    bytes_per_pixel * place.count, std::uint8_t{0});
    else
        for (std::size_t i = 0; i < place.count; ++i)
            std::fill_n(&canvas.rgb[bytes_per_pixel * (row + i * place.step)], bytes_per_pixel,
                        std::uint8_t{0});
    if (!canvas.costs.empty())
        for (std::size_t i = 0; i < place.count; ++i)
            canvas.costs[row + i * place.step] = cost;
}

template <RuleSet rules, bool is_prototype>
void draw_region(const Frame& frame, const Region& region, const Canvas& canvas)
{
    const F64 d;
    const Scene scene = scene_of(frame);
    const unsigned step = region.step;
    const Vec<F64> offsets = hn::Mul(hn::Iota(d, 0.0), Set<F64>(step));
    const std::size_t balls = is_prototype ? frame.ball_count : 1;
    const PixelCost nothing =
        is_prototype ? PixelCost{static_cast<std::uint32_t>(frame.ball_count), 1}
                     : PixelCost{row_of(Outcome::Missed).period, row_of(Outcome::Missed).rays};
    const Span columns{region.x, region.x + region.width};
    const auto place_of = [&](unsigned y, std::size_t first, std::size_t count) {
        return Place{region.size, region.x + static_cast<unsigned>(first) * step, y, step, count};
    };
    const std::size_t count = (region.width + step - 1U) / step; // of a row
    for (unsigned y = region.y; y < unsigned{region.y} + region.height; y += step) {
        Seen seen{};
        Span any{columns.end, columns.first};
        for (std::size_t i = 0; i < balls; ++i) {
            seen[i] = silhouette(rules_of(frame.design, frame.faults), frame, frame.balls[i],
                                 static_cast<std::int32_t>(y), columns);
            if (seen[i].first < seen[i].end)
                any = {std::min(any.first, seen[i].first), std::max(any.end, seen[i].end)};
        }
        const auto pixels_before = [&](std::int32_t column) {
            return (static_cast<std::size_t>(column - columns.first) + step - 1) / step;
        };
        const std::size_t end = any.first < any.end ? pixels_before(any.end) : 0;
        std::size_t at = any.first < any.end ? pixels_before(any.first) : 0;
        put_nothing(place_of(y, 0, at), nothing, canvas);
        for (; at < end; at += lanes<F64>) {
            const Place place = place_of(y, at, std::min(end - at, lanes<F64>));
            const Points target = {hn::Add(Set<F64>(place.first), offsets), Set<F64>(y),
                                   Set<F64>(frame.screen)};
            Shown shown;
            if constexpr (is_prototype)
                shown = prototype_pixels<rules>(scene, target, seen, place);
            else
                shown = rtl_pixels<rules>(scene, target);
            if (hn::AllTrue(d, shown.exact))
                put(shown, place, canvas);
            else
                draw_alone(frame, place, canvas);
        }
        put_nothing(place_of(y, end, count - end), nothing, canvas);
    }
}

void draw(const Picture& picture, const Region& region, const Canvas& canvas) noexcept
{
    const Frame frame = held(frame_of<Frame>(picture));
    const bool corrected = frame.faults == Faults::Corrected;
    if (frame.design == Design::Prototype)
        return corrected ? draw_region<RuleSet::Corrected, true>(frame, region, canvas)
                         : draw_region<RuleSet::Prototype, true>(frame, region, canvas);
    if (corrected)
        return draw_region<RuleSet::Corrected, false>(frame, region, canvas);
    return frame.faults == Faults::Kept
               ? draw_region<RuleSet::Rtl, false>(frame, region, canvas)
               : draw_region<RuleSet::Repaired, false>(frame, region, canvas);
}

} // namespace raymarch::engine::sphere::fast::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif

#if HWY_ONCE
#include "engine/fast/kernel_table.hpp"
#if HWY_ARCH_ARM_V7 // its vectors have no double
std::span<const raymarch::engine::Kernel> raymarch::engine::sphere::fast::kernels() noexcept
{
    return {};
}
#else
RAYMARCH_DEFINE_KERNELS(sphere)
#endif
#endif
