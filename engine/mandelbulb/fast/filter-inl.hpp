// SPDX-License-Identifier: MIT
/// @file
/// Rays in double precision, with a bound of how far off the reference they may be. Where every
/// decision of a ray is clear of its bound, the reference decides the same: the pixel and its cost
/// are known, at a small part of the work. All other rays are left to orbits-inl.hpp.
/// docs/engine/mandelbulb.md, "Fast kernels", has the proof; names there are names here.
#if defined(RAYMARCH_ENGINE_MANDELBULB_FAST_FILTER) == defined(HWY_TARGET_TOGGLE)
#ifdef RAYMARCH_ENGINE_MANDELBULB_FAST_FILTER
#undef RAYMARCH_ENGINE_MANDELBULB_FAST_FILTER
#else
#define RAYMARCH_ENGINE_MANDELBULB_FAST_FILTER
#endif

#include "engine/mandelbulb/fast/bounds.hpp"
#include "engine/mandelbulb/fast/orbits-inl.hpp"

#include <hwy/contrib/math/math-inl.h>

#include <array>
#include <bit>
#include <cmath>
#include <cstring>

HWY_BEFORE_NAMESPACE();
namespace raymarch::engine::mandelbulb::fast::HWY_NAMESPACE
{

#if HWY_HAVE_FLOAT64

/// A unit vector of the plane.
struct Heading
{
    Vec<F64> cosine;
    Vec<F64> sine;
};

HWY_INLINE Heading times(const Heading& a, const Heading& b)
{
    return {hn::NegMulAdd(a.sine, b.sine, hn::Mul(a.cosine, b.cosine)),
            hn::MulAdd(a.sine, b.cosine, hn::Mul(a.cosine, b.sine))};
}

/// The angle n times; n > 0.
HWY_INLINE Heading turned(Heading square, int n)
{
    for (; n % 2 == 0; n /= 2)
        square = times(square, square);
    Heading result = square;
    while ((n /= 2) != 0) {
        square = times(square, square);
        if (n % 2 != 0)
            result = times(result, square);
    }
    return result;
}

HWY_INLINE Vec<F64> power(Vec<F64> square, int n)
{
    for (; n % 2 == 0; n /= 2)
        square = hn::Mul(square, square);
    Vec<F64> result = square;
    while ((n /= 2) != 0) {
        square = hn::Mul(square, square);
        if (n % 2 != 0)
            result = hn::Mul(result, square);
    }
    return result;
}

/// All rays share these numbers, in double precision.
struct RealCourse
{
    Bounds bounds;
    int power;
    bool saturating;
    double radius; ///< an orbit escapes beyond it
    double last;   ///< the index at which an orbit stops in any case
    double origin[3];
    double first; ///< the distance at the origin, which is every ray's first evaluation
    double epsilon;
    double farthest;
    double evaluations; ///< the most of a ray
    double widening;    ///< how fast the map's first derivative grows beside a point
};

/// The nearest double.
template <typename Format>
double real_of(typename Format::Coordinate a)
{
    // Both parts are exact: the sum is the nearest double.
    const double high = static_cast<double>(static_cast<std::int64_t>(a >> 32));
    const double low = static_cast<std::uint32_t>(a);
    return std::ldexp(std::ldexp(high, 32) + low, -Format::fraction_bits);
}

template <typename Format>
RealCourse real_course(const Course<Format>& course)
{
    const Arithmetic& with = course.with;
    const double d = with.power;
    return {.bounds = bounds_of(with, Format::fraction_bits),
            .power = with.power,
            .saturating = with.derivative == DerivativeForm::Saturating,
            .radius = real_of<Format>(escape_radius<Format>(with.power)),
            .last = static_cast<double>(with.iterations - 1),
            .origin = {real_of<Format>(course.origin.x), real_of<Format>(course.origin.y),
                       real_of<Format>(course.origin.z)},
            .first = real_of<Format>(course.first),
            .epsilon = real_of<Format>(course.epsilon),
            .farthest = real_of<Format>(farthest<Format>),
            .evaluations = static_cast<double>(course.limits.evaluations),
            .widening = d * d * d / 2.9 + 1.2 * d + 2};
}

/// One ray and its orbit, or a vector of them. The real orbit is a function of t; `_off` bounds how
/// far the number before it is from that function's value at any t within t_off, `_noise` how far
/// the pipeline and this computation together are from the function.
template <class Number>
struct TrackOf
{
    Number direction[3];
    Number point_noise;
    Number t;
    Number t_off;
    Number evaluations;

    Number w[3];
    Number noise;      ///< of w
    Number tangent[3]; ///< dw/dt
    Number tangent_off;
    Number dr;
    Number dr_noise;
    Number dr_slope; ///< d dr/dt
    Number dr_slope_off;
    Number index;
};
using Track = TrackOf<Vec<F64>>;
inline constexpr std::size_t track_columns = sizeof(TrackOf<double>) / sizeof(double);

/// Begins an orbit at the ray's t.
HWY_INLINE void place(const RealCourse& course, Track& track)
{
    for (std::size_t axis = 0; axis < 3; ++axis) {
        track.w[axis] = hn::MulAdd(track.t, track.direction[axis], Set<F64>(course.origin[axis]));
        track.tangent[axis] = track.direction[axis];
    }
    track.noise = track.tangent_off = track.point_noise;
    track.dr = Set<F64>(1);
    track.dr_noise = track.dr_slope = track.dr_slope_off = track.index = hn::Zero(F64());
}

/// A ray along `vector`, of any length, behind its first evaluation.
inline TrackOf<double> start_of(const RealCourse& course, const Direction& vector)
{
    const double along[3] = {static_cast<double>(vector.x), static_cast<double>(vector.y),
                             static_cast<double>(vector.z)};
    const double length =
        std::sqrt(along[0] * along[0] + along[1] * along[1] + along[2] * along[2]);
    TrackOf<double> track{};
    track.t = course.first;
    track.t_off = std::ldexp(course.first, -52);
    track.evaluations = 1;
    // The reference has the length's floor, 57 bits of the ray, and more of the point.
    track.point_noise = 0x1p-46 + 20 / length;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        track.direction[axis] = track.tangent[axis] = along[axis] / length;
        track.w[axis] = course.origin[axis] + track.t * track.direction[axis];
    }
    track.noise = track.tangent_off = track.point_noise;
    track.dr = 1;
    return track;
}

/// Products of sums that the names below are made of.
HWY_INLINE Vec<F64> sum(Vec<F64> a, Vec<F64> b)
{
    return hn::Add(a, b);
}
HWY_INLINE Vec<F64> sum(Vec<F64> a, Vec<F64> b, Vec<F64> c)
{
    return hn::Add(hn::Add(a, b), c);
}
HWY_INLINE Vec<F64> product(Vec<F64> a, Vec<F64> b)
{
    return hn::Mul(a, b);
}
HWY_INLINE Vec<F64> product(Vec<F64> a, Vec<F64> b, Vec<F64> c)
{
    return hn::Mul(hn::Mul(a, b), c);
}
HWY_INLINE Vec<F64> product(double a, Vec<F64> b)
{
    return hn::Mul(Set<F64>(a), b);
}

/// A point as the cores see it first.
struct Measure
{
    Vec<F64> across; ///< from the z axis
    Vec<F64> r;
    Vec<F64> speed;    ///< |tangent| at most
    Vec<F64> off;      ///< how far any point in question is from w
    Vec<F64> r_noise;  ///< of the pipeline's radius
    Vec<F64> r_margin; ///< r_noise, and what t_off makes of it
    Vec<F64> dr_off;
    Mask<F64> sound; ///< the bounds hold
};

HWY_INLINE Measure measure(const RealCourse& course, const Track& track)
{
    const Bounds& bounds = course.bounds;
    const auto square = [](const Vec<F64>(&v)[3]) {
        return std::array<Vec<F64>, 2>{hn::MulAdd(v[0], v[0], hn::Mul(v[1], v[1])),
                                       hn::Mul(v[2], v[2])};
    };
    const auto [flat, high] = square(track.w);
    const auto [flat_speed, high_speed] = square(track.tangent);
    Measure m;
    m.across = hn::Sqrt(flat);
    m.r = hn::Sqrt(hn::Add(flat, high));
    m.speed = sum(hn::Sqrt(hn::Add(flat_speed, high_speed)), track.tangent_off);
    const Vec<F64> moved = product(m.speed, track.t_off);
    m.off = sum(track.noise, moved);
    m.r_noise = hn::MulAdd(m.r, Set<F64>(bounds.radius_relative),
                           sum(track.noise, Set<F64>(bounds.radius_absolute)));
    m.r_margin = sum(m.r_noise, moved);
    m.dr_off =
        hn::MulAdd(sum(hn::Abs(track.dr_slope), track.dr_slope_off), track.t_off, track.dr_noise);
    m.sound = hn::And(hn::And(hn::Lt(product(8 * course.widening, m.off), m.across),
                              hn::Gt(m.across, Set<F64>(0x1p-20))),
                      hn::Lt(m.dr_off, product(0x1p-6, track.dr)));
    if (course.saturating)
        m.sound = hn::And(m.sound, hn::Lt(track.dr, Set<F64>(0x1p31)));
    return m;
}

/// A point of an orbit as its core computes with it.
struct Core
{
    Vec<F64> by_r;        ///< 1 / r
    Vec<F64> by_across;   ///< 1 / across
    Vec<F64> p;           ///< r^(d-1)
    Vec<F64> q;           ///< r^d
    Vec<F64> slenderness; ///< r / across
    Vec<F64> squeeze;     ///< of circles about the axis
    Vec<F64> stretch;     ///< d p
    Vec<F64> v_r;         ///< the tangent's part along the point
};

/// Moves w and its tangent on.
HWY_INLINE Core move_point(const RealCourse& course, const Track& track, const Measure& m,
                           Track& next)
{
    const double d = course.power;
    const Vec<F64> one = Set<F64>(1);
    Core core{.by_r = hn::Div(one, m.r), .by_across = hn::Div(one, m.across)};
    const auto& [x, y, z] = track.w;
    const auto& [vx, vy, vz] = track.tangent;

    const Heading theta{product(z, core.by_r), product(m.across, core.by_r)};
    const Heading phi{product(x, core.by_across), product(y, core.by_across)};
    const Heading up = turned(theta, course.power);
    const Heading round = turned(phi, course.power);
    core.p = power(m.r, course.power - 1);
    core.q = product(core.p, m.r);
    core.slenderness = product(m.r, core.by_across);
    core.squeeze = product(up.sine, core.slenderness);
    core.stretch = product(d, core.p);

    // The tangent in the frame of r, theta and phi, and from there into that of the image.
    const Vec<F64> outwards = hn::MulAdd(vx, phi.cosine, product(vy, phi.sine));
    const Vec<F64> v_phi = hn::MulSub(vy, phi.cosine, product(vx, phi.sine));
    core.v_r = hn::MulAdd(theta.sine, outwards, product(theta.cosine, vz));
    const Vec<F64> v_theta = hn::MulSub(theta.cosine, outwards, product(theta.sine, vz));
    const Vec<F64> along = product(core.stretch, core.v_r);
    const Vec<F64> downwards = product(core.stretch, v_theta);
    const Vec<F64> sideways = product(core.stretch, core.squeeze, v_phi);
    const Vec<F64> flat_tangent = hn::MulAdd(along, up.sine, product(downwards, up.cosine));
    const Vec<F64> flat = product(core.q, up.sine);

    next.w[0] = product(flat, round.cosine);
    next.w[1] = product(flat, round.sine);
    next.w[2] = product(core.q, up.cosine);
    next.tangent[0] = hn::MulSub(flat_tangent, round.cosine, product(sideways, round.sine));
    next.tangent[1] = hn::MulAdd(flat_tangent, round.sine, product(sideways, round.cosine));
    next.tangent[2] = hn::MulSub(along, up.cosine, product(downwards, up.sine));
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const Vec<F64> c =
            hn::MulAdd(track.t, track.direction[axis], Set<F64>(course.origin[axis]));
        next.w[axis] = hn::Add(next.w[axis], c);
        next.tangent[axis] = hn::Add(next.tangent[axis], track.direction[axis]);
    }
    return core;
}

/// Moves the bounds of w and its tangent on.
HWY_INLINE void move_bounds(const RealCourse& course, const Track& track, const Measure& m,
                            const Core& core, Track& next)
{
    const Bounds& bounds = course.bounds;
    const double d = course.power;
    const Vec<F64> one = Set<F64>(1);
    const Vec<F64> widest = hn::Max(one, hn::Abs(core.squeeze));
    const Vec<F64> grown =
        hn::MulAdd(product(course.widening, m.off), core.by_across, one); // of the derivative
    const Vec<F64> lipschitz = product(core.stretch, widest, grown);
    next.noise = hn::MulAdd(lipschitz, track.noise,
                            hn::MulAdd(core.q, Set<F64>(bounds.q),
                                       hn::MulAdd(core.p, Set<F64>(bounds.p),
                                                  sum(Set<F64>(bounds.c), track.point_noise))));
    const Vec<F64> bend = product(
        1.43 * d * d, product(core.p, core.by_r,
                              sum(hn::MulAdd(product(2, widest), widest, one), widest,
                                  product(1.5, product(core.slenderness, sum(one, widest))))));
    next.tangent_off =
        hn::MulAdd(lipschitz, hn::MulAdd(Set<F64>(0x1p-44), m.speed, track.tangent_off),
                   hn::MulAdd(bend, product(m.off, m.speed), track.point_noise));
}

/// Moves dr, its slope and their bounds on.
HWY_INLINE void move_derivative(const RealCourse& course, const Track& track, const Measure& m,
                                const Core& core, Track& next)
{
    const Bounds& bounds = course.bounds;
    const double d = course.power;
    const Vec<F64> one = Set<F64>(1);
    // dr' = d P dr + 1, with the middle of what the pipeline's floor takes away.
    const Vec<F64> tilt = product(m.off, core.by_r);
    const Vec<F64> p_by_r = product(d - 1, product(core.p, core.by_r));
    const Vec<F64> p_slope = product(p_by_r, core.v_r);
    const Vec<F64> p_off = product(1.1, product(p_by_r, m.off));
    const Vec<F64> p_noise =
        hn::MulAdd(product(1.1, p_by_r), m.r_noise,
                   hn::MulAdd(Set<F64>(2.2 * d * bounds.kept), core.p,
                              product(bounds.power_floor, hn::Max(one, core.p))));
    const Vec<F64> p_slope_off = product(
        1.1, product(p_by_r, hn::MulAdd(product(d - 2, tilt), hn::Abs(core.v_r),
                                        hn::MulAdd(product(2, tilt), m.speed, track.tangent_off))));
    const Vec<F64> p_most = sum(core.p, p_off);
    const Vec<F64> slope = hn::Abs(track.dr_slope);
    constexpr double floor_half = 0x1p-33;
    next.dr = hn::MulAdd(core.stretch, track.dr, Set<F64>(1 - floor_half * d));
    next.dr_slope = product(d, hn::MulAdd(p_slope, track.dr, product(core.p, track.dr_slope)));
    next.dr_noise =
        hn::MulAdd(product(d, p_most), track.dr_noise,
                   hn::MulAdd(product(1.1 * d, track.dr), p_noise,
                              hn::MulAdd(next.dr, Set<F64>(0x1p-44), Set<F64>(floor_half * d))));
    const Vec<F64> slopes = hn::MulAdd(hn::Abs(p_slope), track.dr, product(core.p, slope));
    next.dr_slope_off = product(
        d,
        sum(hn::MulAdd(p_most, track.dr_slope_off, product(slope, p_off)),
            hn::MulAdd(p_slope_off, sum(track.dr, m.dr_off), product(hn::Abs(p_slope), m.dr_off)),
            product(0x1p-44, slopes)));
}

/// One core: the track a step on.
HWY_INLINE Track moved_on(const RealCourse& course, const Track& track, const Measure& m)
{
    Track next = track;
    const Core core = move_point(course, track, m, next);
    move_bounds(course, track, m, core, next);
    move_derivative(course, track, m, core, next);
    next.index = sum(track.index, Set<F64>(1));
    return next;
}

/// The distance at a point that has escaped, and where it takes the ray.
struct Advance
{
    Vec<F64> distance;
    Vec<F64> distance_off;
    Vec<F64> t;
    Vec<F64> t_off;
};

HWY_INLINE Advance advance(const RealCourse& course, const Track& track, const Measure& m)
{
    const Bounds& bounds = course.bounds;
    const Vec<F64> one = Set<F64>(1);
    const Vec<F64> by_dr = hn::Div(one, track.dr);
    const Vec<F64> by_r = hn::Div(one, m.r);
    const Vec<F64> l = hn::Log(F64(), m.r);
    const Vec<F64> half = product(0.5, product(m.r, l));
    const Vec<F64> half_slope = product(0.5, sum(one, l)); // by r
    const Vec<F64> v_r = product(
        hn::MulAdd(track.w[0], track.tangent[0],
                   hn::MulAdd(track.w[1], track.tangent[1], product(track.w[2], track.tangent[2]))),
        by_r);
    const Vec<F64> slope = hn::Abs(track.dr_slope);
    const Vec<F64> tilted = product(product(m.off, by_r), m.speed);

    Advance result;
    result.distance = product(half, by_dr);
    const Vec<F64> g =
        product(hn::NegMulAdd(result.distance, track.dr_slope, product(half_slope, v_r)), by_dr);
    const Vec<F64> half_noise =
        hn::MulAdd(half_slope, m.r_noise,
                   sum(product(0.5 * bounds.logarithm, m.r), product(2 * bounds.kept, half)));
    const Vec<F64> noise = product(
        1.25, hn::MulAdd(half_noise, by_dr,
                         hn::MulAdd(result.distance,
                                    hn::MulAdd(track.dr_noise, by_dr, Set<F64>(bounds.quotient)),
                                    Set<F64>(bounds.distance_unit))));
    const Vec<F64> distance_span = product(
        1.1, product(hn::MulAdd(half_slope, m.off, product(result.distance, m.dr_off)), by_dr));
    const Vec<F64> half_slope_off = hn::MulAdd(
        half_slope, hn::MulAdd(Set<F64>(1.05), tilted, track.tangent_off), product(0.55, tilted));
    const Vec<F64> g_off =
        product(1.1, product(sum(hn::MulAdd(result.distance, track.dr_slope_off, half_slope_off),
                                 hn::MulAdd(sum(slope, track.dr_slope_off), distance_span,
                                            product(hn::Abs(g), m.dr_off))),
                             by_dr));
    const Vec<F64> uncertain = hn::MulAdd(g_off, track.t_off, noise);
    result.distance_off = hn::MulAdd(hn::Abs(g), track.t_off, uncertain);
    result.t = sum(track.t, result.distance);
    result.t_off = hn::MulAdd(hn::Abs(sum(one, g)), track.t_off, sum(uncertain, Set<F64>(0x1p-48)));
    return result;
}

/// Marches rays from their second evaluation on. `Rays` gives vectors along them, or says that
/// there are no more: bool next(Ray&); it takes how one ended: void finish(pixel, outcome,
/// evaluations, index), or that its end is not known: void leave(pixel).
template <class Rays>
class Filter
{
  public:
    Filter(const RealCourse& course, Rays& rays) : course_(course), rays_(rays) {}

    void run()
    {
        for (std::size_t lane = 0; lane < pixels_.size(); ++lane)
            start(lane);
        while (under_way_ > 0)
            for (std::size_t j = 0; j < in_flight; ++j)
                step(j);
    }

  private:
    static constexpr std::size_t nothing = ~std::size_t{0};
    using Columns = std::array<std::array<double, lanes<F64>>, track_columns>;

    /// An evaluation decides this about rays. In a lane at most one of hit, miss, limit and
    /// proceeds is set where the bounds are known to hold.
    struct Verdict
    {
        Mask<F64> known;
        Mask<F64> hit;
        Mask<F64> miss;
        Mask<F64> limit;
        Mask<F64> proceeds;
        Vec<F64> evaluations; ///< with this one
    };

    void step(std::size_t j)
    {
        Track track;
        static_assert(sizeof(track) == sizeof(Columns));
        std::memcpy(&track, &columns_[j], sizeof(track));
        const Measure m = measure(course_, track);
        const Vec<F64> radius = Set<F64>(course_.radius);
        const Vec<F64> most = hn::Add(m.r, m.r_margin);
        const Mask<F64> beyond = hn::Gt(hn::Sub(m.r, m.r_margin), radius);
        const Mask<F64> within = hn::Lt(most, radius);
        const Mask<F64> last = hn::Eq(track.index, Set<F64>(course_.last));
        const Mask<F64> inside = hn::And(hn::And(last, within), hn::Lt(most, Set<F64>(1)));
        const Mask<F64> going = hn::And(m.sound, hn::AndNot(last, within));
        if (hn::AllTrue(F64(), going)) {
            track = moved_on(course_, track, m);
            std::memcpy(&columns_[j], &track, sizeof(track));
            return;
        }
        const Advance next = advance(course_, track, m);
        Verdict verdict = judge(track, next, inside);
        verdict.known = hn::And(m.sound, hn::Or(beyond, inside));
        verdict.proceeds = hn::And(verdict.proceeds, verdict.known);
        Track fresh = track;
        fresh.t = next.t;
        fresh.t_off = next.t_off;
        fresh.evaluations = verdict.evaluations;
        place(course_, fresh);
        const std::array<Vec<F64>, track_columns> ahead =
            std::bit_cast<std::array<Vec<F64>, track_columns>>(moved_on(course_, track, m));
        const auto placed = std::bit_cast<std::array<Vec<F64>, track_columns>>(fresh);
        for (std::size_t i = 0; i < track_columns; ++i)
            hn::StoreU(hn::IfThenElse(going, ahead[i], placed[i]), F64(), columns_[j][i].data());
        end_others(j, hn::Or(going, verdict.proceeds), verdict, track.index);
    }

    /// `known` is the caller's.
    HWY_INLINE Verdict judge(const Track& track, const Advance& next, Mask<F64> inside) const
    {
        // Nearer to a number than this, a double may be on the other side of what it stands for.
        constexpr double nearly = 1 + 0x1p-50;
        const Vec<F64> epsilon = Set<F64>(course_.epsilon);
        const Vec<F64> farthest = Set<F64>(course_.farthest);
        const Vec<F64> most = hn::Add(next.distance, next.distance_off);
        const Mask<F64> clear =
            hn::Gt(hn::Sub(next.distance, next.distance_off), Set<F64>(nearly * course_.epsilon));
        const Mask<F64> stays = hn::And(clear, hn::Lt(hn::Add(next.t, next.t_off), farthest));
        Verdict verdict;
        verdict.evaluations = hn::Add(track.evaluations, Set<F64>(1));
        verdict.hit = hn::Or(inside, hn::Lt(product(nearly, most), epsilon));
        verdict.miss = hn::And(clear, hn::Gt(hn::Sub(next.t, next.t_off), farthest));
        verdict.limit = hn::And(stays, hn::Ge(verdict.evaluations, Set<F64>(course_.evaluations)));
        verdict.proceeds = hn::AndNot(verdict.limit, stays);
        return verdict;
    }

    /// Ends the rays of vector j that are not `open`.
    HWY_INLINE void end_others(std::size_t j, Mask<F64> open, const Verdict& verdict,
                               Vec<F64> index)
    {
        if (hn::AllTrue(F64(), open))
            return;
        const auto bits = [](Mask<F64> mask) {
            std::array<std::uint8_t, 8> bytes{};
            hn::StoreMaskBits(F64(), mask, bytes.data());
            return unsigned{bytes[0]};
        };
        const unsigned others = bits(hn::Not(open));
        const unsigned known = bits(verdict.known);
        const unsigned hits = known & bits(verdict.hit);
        const unsigned misses = known & bits(verdict.miss);
        const unsigned limits = known & bits(verdict.limit);
        std::array<double, lanes<F64>> made;
        std::array<double, lanes<F64>> indices;
        hn::StoreU(verdict.evaluations, F64(), made.data());
        hn::StoreU(index, F64(), indices.data());
        for (std::size_t i = 0; i < lanes<F64>; ++i)
            if ((others >> i & 1) != 0)
                end(j * lanes<F64> + i,
                    (hits >> i & 1) != 0     ? Outcome::Hit
                    : (misses >> i & 1) != 0 ? Outcome::Miss
                                             : Outcome::Limit,
                    ((hits | misses | limits) >> i & 1) != 0, static_cast<int>(made[i]),
                    static_cast<int>(indices[i]));
    }

    void end(std::size_t lane, Outcome outcome, bool known, int evaluations, int index)
    {
        const std::size_t pixel = pixels_[lane];
        if (pixel == nothing)
            return;
        if (known)
            rays_.finish(pixel, outcome, evaluations, index);
        else
            rays_.leave(pixel);
        --under_way_;
        start(lane);
    }

    void start(std::size_t lane)
    {
        pixels_[lane] = nothing;
        Ray ray;
        if (!rays_.next(ray))
            return;
        pixels_[lane] = ray.pixel;
        ++under_way_;
        const auto track = start_of(course_, ray.direction);
        const auto values = std::bit_cast<std::array<double, track_columns>>(track);
        for (std::size_t i = 0; i < track_columns; ++i)
            columns_[lane / lanes<F64>][i][lane % lanes<F64>] = values[i];
    }

    const RealCourse& course_;
    Rays& rays_;
    std::size_t under_way_ = 0;
    std::array<std::size_t, in_flight * lanes<F64>> pixels_{};
    HWY_ALIGN std::array<Columns, in_flight> columns_{};
};

#endif

} // namespace raymarch::engine::mandelbulb::fast::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
