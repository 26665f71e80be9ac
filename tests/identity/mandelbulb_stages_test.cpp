// SPDX-License-Identifier: MIT
// The stages of the Mandelbulb's kernels against those of the reference, in every instruction set;
// and the filter's bounds against the errors that they bound.
#include "engine/draw.hpp"
#include "engine/fast/targets.hpp"
#include "engine/mandelbulb/distance.hpp"
#include "engine/mandelbulb/fast/bounds.hpp"
#include "engine/mandelbulb/ray_generator.hpp"
#include "engine/mandelbulb/ray_marcher.hpp"
#include "tests/fakes/random.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstring>
#include <random>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "tests/identity/mandelbulb_stages_test.cpp"
#include <hwy/foreach_target.h>
// Behind foreach_target.h.
#include <hwy/highway.h>
#if HWY_TARGET != HWY_SCALAR && HWY_TARGET != HWY_EMU128
#include "engine/mandelbulb/fast/filter-inl.hpp"
#include "engine/mandelbulb/fast/orbits-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace raymarch::engine::mandelbulb::fast::HWY_NAMESPACE
{

using test::pick;
using Format = Q57<Int128>;
using Random = std::mt19937_64;
using Numbers = std::array<std::uint64_t, batch>;
constexpr int rounds = 2000;

constexpr std::int64_t as_signed(std::uint64_t a)
{
    return static_cast<std::int64_t>(a);
}

/// Of any size up to `bits` bits: as many of few bits as of many.
std::uint64_t any_below(Random& random, int bits)
{
    const int length = pick(random, 0, bits);
    return length == 0 ? 0 : random() >> (64 - length);
}

std::uint64_t any_signed(Random& random, int bits)
{
    const std::uint64_t magnitude = any_below(random, bits);
    return random() % 2 == 0 ? magnitude : 0 - magnitude;
}

template <class Make>
Numbers numbers(Make make)
{
    Numbers result;
    for (std::uint64_t& each : result)
        each = make();
    return result;
}

Numbers numbers_of(const Batch& batch_of)
{
    Numbers result;
    store(batch_of, result.data());
    return result;
}

/// With the gain of the rotations no number reaches 64 units.
constexpr int vector_bits = 61;
constexpr int radius_bits = 62;

void vectoring()
{
    Random random = test::seeded_random();
    for (int round = 0; round < rounds; ++round) {
        const int steps = pick(random, min_steps, max_steps);
        const Numbers x = numbers([&] { return any_signed(random, vector_bits); });
        Numbers y = numbers([&] { return any_signed(random, vector_bits); });
        if (round % 8 == 0)
            y = x; // on a diagonal
        if (round % 8 == 1)
            y = {};
        const PolarBatch polar = to_polar(Cordic(steps), load(x.data()), load(y.data()));
        const Numbers magnitude = numbers_of(polar.magnitude);
        const Numbers angle = numbers_of(polar.angle);
        for (std::size_t i = 0; i < batch; ++i) {
            const auto expected =
                mandelbulb::to_polar<Format>(as_signed(x[i]), as_signed(y[i]), steps);
            ASSERT_EQ(as_signed(magnitude[i]), expected.magnitude) << x[i] << " " << y[i];
            ASSERT_EQ(angle[i], expected.angle) << x[i] << " " << y[i] << " " << steps;
        }
    }
}

void rotation()
{
    Random random = test::seeded_random();
    for (int round = 0; round < rounds; ++round) {
        const int steps = pick(random, min_steps, max_steps);
        const Numbers r = numbers([&] { return any_signed(random, radius_bits); });
        Numbers turn = numbers([&] { return random(); });
        if (round % 8 == 0) // about the ends of the quadrants
            for (std::uint64_t& each : turn)
                each = (random() % 8 << 61) + any_signed(random, 8);
        const CartesianBatch point = to_cartesian(Cordic(steps), load(r.data()), load(turn.data()));
        const Numbers x = numbers_of(point.x);
        const Numbers y = numbers_of(point.y);
        for (std::size_t i = 0; i < batch; ++i) {
            const auto expected = mandelbulb::to_cartesian<Format>(as_signed(r[i]), turn[i], steps);
            ASSERT_EQ(as_signed(x[i]), expected.x) << r[i] << " " << turn[i] << " " << steps;
            ASSERT_EQ(as_signed(y[i]), expected.y) << r[i] << " " << turn[i] << " " << steps;
        }
    }
}

void multiplier()
{
    Random random = test::seeded_random();
    for (int round = 0; round < rounds; ++round) {
        const int kept = pick(random, 8, 64);
        const Numbers a = numbers([&] { return any_below(random, 64); });
        const Numbers b = numbers([&] { return any_below(random, 64); });
        const Batch a_batch = load(a.data());
        const Batch b_batch = load(b.data());
        Batch kept_batch;
        Batch high;
        Batch low;
        Batch length;
        for (std::size_t j = 0; j < in_flight; ++j) {
            const DoubleWord product = multiply(a_batch[j], b_batch[j]);
            high[j] = product.high;
            low[j] = product.low;
            kept_batch[j] = mandelbulb::fast::HWY_NAMESPACE::keep(a_batch[j], kept);
            length[j] = bit_length(a_batch[j]);
        }
        for (std::size_t i = 0; i < batch; ++i) {
            ASSERT_EQ(numbers_of(high)[i], high_product(a[i], b[i]));
            ASSERT_EQ(numbers_of(low)[i], a[i] * b[i]);
            ASSERT_EQ(numbers_of(kept_batch)[i], mandelbulb::keep(a[i], kept)) << a[i];
            ASSERT_EQ(numbers_of(length)[i], a[i] == 0 ? 0U : leading_one(a[i]) + 1U);
        }
    }
}

void powers_and_derivative()
{
    Random random = test::seeded_random();
    for (int round = 0; round < rounds; ++round) {
        const int d = pick(random, 2, 16);
        const int kept = pick(random, 8, 64);
        const auto radius = static_cast<std::uint64_t>(escape_radius<Format>(d));
        const Numbers r = numbers([&] {
            return round % 4 == 0 ? radius - any_below(random, 6) : any_below(random, 60) % radius;
        });
        const Numbers mantissa =
            numbers([&] { return (random() | 1ULL << 63) >> (random() % 32); });
        const Numbers fraction = numbers(
            [&] { return static_cast<std::uint64_t>(pick<std::int64_t>(random, -600, 32)); });
        const PowersBatch power = mandelbulb::fast::HWY_NAMESPACE::powers(load(r.data()), d, kept);
        for (const DerivativeForm form : {DerivativeForm::Sliding, DerivativeForm::Saturating}) {
            const DerivativeBatch next = mandelbulb::fast::HWY_NAMESPACE::next_derivative(
                {load(mantissa.data()), load(fraction.data())}, power.kept_lower, d, kept, form);
            for (std::size_t i = 0; i < batch; ++i) {
                const auto expected = mandelbulb::powers<Format>(as_signed(r[i]), d, kept);
                ASSERT_EQ(as_signed(numbers_of(power.upper)[i]), expected.upper) << r[i];
                const Derivative dr = mandelbulb::next_derivative<Format>(
                    {mantissa[i], static_cast<int>(as_signed(fraction[i]))}, expected.lower, d,
                    kept, form);
                ASSERT_EQ(numbers_of(next.mantissa)[i], dr.mantissa) << mantissa[i];
                ASSERT_EQ(as_signed(numbers_of(next.fraction_bits)[i]), dr.fraction_bits);
            }
        }
    }
}

void distance()
{
    Random random = test::seeded_random();
    for (int round = 0; round < rounds; ++round) {
        const Arithmetic with{.steps = pick(random, min_steps, max_steps),
                              .kept_bits = pick(random, 8, 64),
                              .scale = random() % 2 == 0 ? 0 : pick(random, 1, 60)};
        const Numbers r = numbers([&] {
            return round % 4 == 0 ? unit + any_signed(random, 40)
                                  : any_below(random, 62) % (32 * unit);
        });
        // A derivative of 1 and more.
        const Numbers fraction = numbers(
            [&] { return static_cast<std::uint64_t>(pick<std::int64_t>(random, -100, 32)); });
        const Numbers mantissa = numbers([&] { return random() | 1ULL << pick(random, 32, 63); });
        const Numbers result = numbers_of(mandelbulb::fast::HWY_NAMESPACE::distance_of(
            load(r.data()), {load(mantissa.data()), load(fraction.data())}, with));
        for (std::size_t i = 0; i < batch; ++i)
            ASSERT_EQ(
                as_signed(result[i]),
                mandelbulb::distance_of<Format>(
                    as_signed(r[i]), {mantissa[i], static_cast<int>(as_signed(fraction[i]))}, with))
                << r[i] << " " << mantissa[i] << " " << as_signed(fraction[i]);
    }
}

#if HWY_HAVE_FLOAT64

double first_lane(Vec<F64> v)
{
    return hn::GetLane(v);
}

/// How much of its bound an error takes.
struct Shares
{
    double radius = 0;
    double derivative = 0;
    double distance = 0;
    double way = 0;

    static void take(double& share, long double error, Vec<F64> bound)
    {
        share = std::max(share, static_cast<double>(std::abs(error) / first_lane(bound)));
    }
};

long double value(std::int64_t a)
{
    return std::ldexp(static_cast<long double>(a), -unit_bits);
}

/// One ray beside the reference for as long as the filter answers for it. Returns how many
/// evaluations that is.
int accompany(const RealCourse& real, const Arithmetic& with, const Point<Format>& origin,
              const Direction& vector, std::int64_t first, Shares& shares)
{
    const Direction direction = unit_vector(vector);
    Track track;
    const auto start = std::bit_cast<std::array<double, track_columns>>(start_of(real, vector));
    std::array<Vec<F64>, track_columns> everywhere;
    for (std::size_t i = 0; i < track_columns; ++i)
        everywhere[i] = hn::Set(F64(), start[i]);
    std::memcpy(&track, &everywhere, sizeof(track));
    std::int64_t t = first;
    for (int evaluations = 1; evaluations < 100; ++evaluations) {
        const Point<Format> point = point_at<Format>(origin, direction, t, 0);
        Orbit<Format> orbit{.w = point, .c = point};
        for (int core = 1;; ++core) {
            const Measure m = measure(real, track);
            if (hn::GetLane(hn::VecFromMask(F64(), m.sound)) == 0 || core == with.iterations)
                return evaluations;
            const long double dr =
                std::ldexp(static_cast<long double>(orbit.dr.mantissa), -orbit.dr.fraction_bits);
            Shares::take(shares.derivative, dr - first_lane(track.dr), m.dr_off);
            const bool goes_on = mandelbulb::iterate(orbit, with, Last::No);
            Shares::take(shares.radius, value(orbit.r) - first_lane(m.r), m.r_margin);
            if (goes_on) {
                track = moved_on(real, track, m);
                continue;
            }
            const Advance next = advance(real, track, m);
            const std::int64_t distance = mandelbulb::distance_of<Format>(orbit.r, orbit.dr, with);
            t += distance;
            Shares::take(shares.distance, value(distance) - first_lane(next.distance),
                         next.distance_off);
            Shares::take(shares.way, value(t) - first_lane(next.t), next.t_off);
            track.t = next.t;
            track.t_off = next.t_off;
            place(real, track);
            break;
        }
        if (t > farthest<Format> || value(t) - value(first) == 0)
            return evaluations;
    }
    return 100;
}

void bounds()
{
    Random random = test::seeded_random();
    Shares shares;
    int evaluations = 0;
    std::uniform_real_distribution<double> place_of(-1.6, 1.6);
    for (int round = 0; round < 4000; ++round) {
        const int steps = pick(random, 20, 64);
        const Arithmetic with{.steps = steps,
                              .kept_bits = pick(random, std::min(24, steps + 4), 64),
                              .power = round % 2 == 0 ? 8 : pick(random, 2, 16),
                              .iterations = 64};
        const auto coordinate = [&] {
            return static_cast<std::int64_t>(std::ldexp(place_of(random), unit_bits));
        };
        const Course<Format> course{.with = with,
                                    .limits = {},
                                    .origin = {coordinate(), coordinate(), coordinate()},
                                    .first = 0,
                                    .epsilon = 1};
        const auto component = [&] { return as_signed(random()) >> 6; };
        const Direction vector{component(), component(), component()};
        Course<Format> moved = course;
        moved.first = estimate<Format>(course.origin, with).distance;
        if (moved.first == 0)
            continue;
        evaluations +=
            accompany(real_course(moved), with, course.origin, vector, moved.first, shares);
    }
    std::cout << evaluations << " evaluations; of its bound the worst error takes: radius "
              << shares.radius << ", derivative " << shares.derivative << ", distance "
              << shares.distance << ", t " << shares.way << '\n';
    EXPECT_GT(evaluations, 10000);
    EXPECT_LE(shares.radius, 1);
    EXPECT_LE(shares.derivative, 1);
    EXPECT_LE(shares.distance, 1);
    EXPECT_LE(shares.way, 1);
}

#else

void bounds() {} // no filter

#endif

} // namespace raymarch::engine::mandelbulb::fast::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif

#if HWY_ONCE

namespace raymarch::engine::mandelbulb::fast
{
namespace
{

using Check = void (*)();
struct CheckRow
{
    Isa isa;
    Check check;
};
#define RAYMARCH_CHECKS(check)                                                                     \
    {                                                                                              \
        CheckRow{Isa::Sse4, HWY_CHOOSE_SSE4(check)}, CheckRow{Isa::Neon, HWY_CHOOSE_NEON(check)},  \
            CheckRow{Isa::Avx2, HWY_CHOOSE_AVX2(check)},                                           \
            CheckRow{Isa::Avx512, HWY_CHOOSE_AVX3(check)},                                         \
    }

void run(std::initializer_list<CheckRow> rows)
{
    for (const CheckRow& row : rows)
        if (row.check != nullptr && supported(row.isa)) {
            SCOPED_TRACE(name_of(row.isa));
            row.check();
        }
}

TEST(MandelbulbStages, VectoringIsTheReferences)
{
    run(RAYMARCH_CHECKS(vectoring));
}

TEST(MandelbulbStages, RotationIsTheReferences)
{
    run(RAYMARCH_CHECKS(rotation));
}

TEST(MandelbulbStages, ProductsAreTheReferences)
{
    run(RAYMARCH_CHECKS(multiplier));
}

TEST(MandelbulbStages, PowersAndTheDerivativeAreTheReferences)
{
    run(RAYMARCH_CHECKS(powers_and_derivative));
}

TEST(MandelbulbStages, TheDistanceIsTheReferences)
{
    run(RAYMARCH_CHECKS(distance));
}

TEST(MandelbulbStages, TheFiltersErrorsStayWithinTheirBounds)
{
    run(RAYMARCH_CHECKS(bounds));
}

} // namespace
} // namespace raymarch::engine::mandelbulb::fast
#endif
