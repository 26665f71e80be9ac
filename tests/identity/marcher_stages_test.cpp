// SPDX-License-Identifier: MIT
#include "marcher_stages.hpp"

#include "engine/fast/targets.hpp"
#include "engine/marcher/inverse_sqrt.hpp"
#include "engine/marcher/inverse_sqrt_table.hpp"
#include "engine/marcher/shading.hpp"
#include "engine/marcher/surface_vectors.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <random>
#include <type_traits>
#include <vector>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "tests/identity/marcher_stages_test.cpp"
#include <hwy/foreach_target.h>

#include <hwy/highway.h>

#if HWY_TARGET != HWY_SCALAR && HWY_TARGET != HWY_EMU128

#include "engine/marcher/fast/ray_marcher-inl.hpp"
#include "engine/marcher/fast/shading-inl.hpp"
#include "engine/marcher/fast/surface_vectors-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace raymarch::engine::marcher::fast::HWY_NAMESPACE
{

Vec<I32> load(const Batch& batch, std::size_t at)
{
    return hn::LoadU(I32(), &batch[at]);
}

Points load(const PointBatch& p, std::size_t at)
{
    return {load(p.x, at), load(p.y, at), load(p.z, at)};
}

void store(Vec<I32> v, Batch& batch, std::size_t at)
{
    hn::StoreU(v, I32(), &batch[at]);
}

void store(const Points& p, PointBatch& batch, std::size_t at)
{
    store(p.x, batch.x, at);
    store(p.y, batch.y, at);
    store(p.z, batch.z, at);
}

Wide load(const Squares64& squares, std::size_t at)
{
    std::array<std::uint64_t, lanes<I32> / 2> even{};
    std::array<std::uint64_t, lanes<I32> / 2> odd{};
    for (std::size_t i = 0; i < lanes<I32> / 2; ++i) {
        even[i] = squares[at + 2 * i];
        odd[i] = squares[at + 2 * i + 1];
    }
    return {hn::LoadU(U64(), even.data()), hn::LoadU(U64(), odd.data())};
}

template <Squares squares>
void inverse_sqrt_of(const Squares64& s, std::size_t at, MantissaBatch& result)
{
    const Normalised n = normalised<squares>(load(s, at));
    store(hn::BitCast(I32(), lower(mantissa(n))), result.mantissa, at);
    store(hn::BitCast(I32(), n.exponent - Set<U32>(exponent_bias)), result.exponent, at);
}

void test_inverse_sqrt(const Squares64& squares, bool small, MantissaBatch& result)
{
    for (std::size_t at = 0; at < batch; at += lanes<I32>)
        if (small)
            inverse_sqrt_of<Squares::Small>(squares, at, result);
        else
            inverse_sqrt_of<Squares::Any>(squares, at, result);
}

void test_length(const Squares64& squares, bool small, Batch& result)
{
    for (std::size_t at = 0; at < batch; at += lanes<I32>)
        store(small ? length<Squares::Small>(load(squares, at))
                    : length<Squares::Any>(load(squares, at)),
              result, at);
}

void test_normalise(const PointBatch& v, bool small, PointBatch& result)
{
    for (std::size_t at = 0; at < batch; at += lanes<I32>)
        store(small ? normalise<Squares::Small>(load(v, at)) : normalise<Squares::Any>(load(v, at)),
              result, at);
}

void test_position(const Point& eye, const PointBatch& direction, const Batch& t,
                   PointBatch& result)
{
    static Rays rays{};
    for (std::size_t at = 0; at < batch; at += lanes<I32>) {
        hn::StoreU(hn::ShiftLeft<direction_shift>(load(direction.x, at)), I32(), rays.x.data());
        hn::StoreU(hn::ShiftLeft<direction_shift>(load(direction.y, at)), I32(), rays.y.data());
        hn::StoreU(hn::ShiftLeft<direction_shift>(load(direction.z, at)), I32(), rays.z.data());
        store(position(points(eye), rays, 0, load(t, at)), result, at);
    }
}

template <class Of>
void distance_of(const PointBatch& p, Batch& result)
{
    for (std::size_t at = 0; at < batch; at += lanes<I32>)
        store(distance<Of>(load(p, at)), result, at);
}

void test_distance(marcher::Scene scene, const PointBatch& p, Batch& result)
{
    switch (scene) {
    case marcher::Scene::Sphere:
        return distance_of<SphereOf<Squares::Any>>(p, result);
    case marcher::Scene::Cube:
        return distance_of<Cube>(p, result);
    case marcher::Scene::InfiniteCube:
        return distance_of<InfiniteCube>(p, result);
    case marcher::Scene::Tunnel:
        return distance_of<Tunnel>(p, result);
    }
}

template <class Of>
void normal_of(const PointBatch& p, PointBatch& result)
{
    for (std::size_t at = 0; at < batch; at += lanes<I32>)
        store(HWY_NAMESPACE::surface_normal<Of>(load(p, at)), result, at);
}

void test_surface_normal(marcher::Scene scene, const PointBatch& p, PointBatch& result)
{
    switch (scene) {
    case marcher::Scene::Sphere:
        return normal_of<SphereOf<Squares::Small>>(p, result);
    case marcher::Scene::Cube:
        return normal_of<Cube>(p, result);
    case marcher::Scene::InfiniteCube:
        return normal_of<InfiniteCube>(p, result);
    case marcher::Scene::Tunnel:
        return normal_of<Tunnel>(p, result);
    }
}

void test_brightness(const PointBatch& normal, const PointBatch& light, Batch& result)
{
    for (std::size_t at = 0; at < batch; at += lanes<I32>)
        store(HWY_NAMESPACE::brightness(load(normal, at), load(light, at)), result, at);
}

void test_shade(const std::array<std::uint16_t, 3>& colour, const Batch& brightness, Batch& result)
{
    for (std::size_t at = 0; at < batch; at += lanes<I32>)
        store(hn::BitCast(I32(), HWY_NAMESPACE::shade(colour, load(brightness, at))), result, at);
}

std::size_t test_compact(std::uint32_t chosen, Batch& numbers, std::size_t& size)
{
    size = lanes<I32>;
    Batch wanted{};
    for (std::size_t i = 0; i < lanes<I32>; ++i)
        wanted[i] = static_cast<std::int32_t>(chosen >> i & 1);
    const Compress<I32> compress(load(wanted, 0) > Set<I32>(0));
    store(compress(load(numbers, 0)), numbers, 0);
    return compress.count();
}

Stages stages_of(Isa isa)
{
    return {isa,           test_inverse_sqrt,   test_length,     test_normalise, test_position,
            test_distance, test_surface_normal, test_brightness, test_shade,     test_compact};
}

} // namespace raymarch::engine::marcher::fast::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif

#if HWY_ONCE

namespace raymarch::engine::marcher::fast
{
namespace
{

/// Those that run here.
std::vector<Stages> stages_here()
{
    struct Row
    {
        Isa isa;
        Stages (*stages)(Isa isa);
    };
    constexpr std::array rows = {
        Row{Isa::Sse4, HWY_CHOOSE_SSE4(stages_of)},
        Row{Isa::Neon, HWY_CHOOSE_NEON(stages_of)},
        Row{Isa::Avx2, HWY_CHOOSE_AVX2(stages_of)},
        Row{Isa::Avx512, HWY_CHOOSE_AVX3(stages_of)},
    };
    std::vector<Stages> here;
    for (const Row& row : rows)
        if (row.stages != nullptr && supported(row.isa))
            here.push_back(row.stages(row.isa));
    return here;
}

class MarcherStages : public testing::TestWithParam<Stages>
{
  protected:
    const Stages& stages = GetParam();
    std::mt19937_64 random{1};

    std::int32_t between(std::int32_t least, std::int32_t most)
    {
        return std::uniform_int_distribution(least, most)(random);
    }
};

/// S with the leading bit e, the next bits `top`, and `rest` below them.
std::uint64_t square_of(int e, std::uint64_t top, int top_bits, std::uint64_t rest)
{
    const std::uint64_t normalised =
        std::uint64_t{1} << 63 | top << (63 - top_bits) | rest >> (top_bits + 1);
    return normalised >> (63 - e);
}

void expect_inverse_sqrt(const Stages& stages, const Squares64& squares)
{
    const bool small = std::ranges::max(squares) < std::uint64_t{1} << 52;
    for (const bool by_small : {false, true}) {
        if (by_small && !small)
            continue;
        MantissaBatch found{};
        stages.inverse_sqrt(squares, by_small, found);
        for (std::size_t i = 0; i < batch; ++i) {
            const InverseSqrt expected = inverse_sqrt(squares[i]);
            ASSERT_EQ(static_cast<std::uint32_t>(found.mantissa[i]), expected.mantissa)
                << squares[i];
            ASSERT_EQ(found.exponent[i], 63 - std::countl_zero(squares[i])) << squares[i];
        }
    }
}

TEST_P(MarcherStages, InverseSqrtOfEveryEntryTimesEveryExponent)
{
    // With the first and last steps of each entry, and bits below them that a rounding would carry.
    constexpr std::uint64_t ones = ~std::uint64_t{0};
    for (int e = 0; e < 64; ++e)
        for (std::uint64_t index = 0; index < 4096; ++index) {
            Squares64 squares{};
            for (std::size_t i = 0; i < batch; ++i) {
                const std::uint64_t steps[] = {0, 1, 16383, 16382, random() & 16383};
                const std::uint64_t step = steps[i % 5];
                const std::uint64_t rest = i < 5 ? 0 : i < 10 ? ones : random();
                squares[i] = square_of(e, index << 14 | step, 26, rest);
            }
            ASSERT_NO_FATAL_FAILURE(expect_inverse_sqrt(stages, squares));
        }
}

TEST_P(MarcherStages, InverseSqrtOfEveryStepOfSomeEntries)
{
    for (const std::uint64_t index : {0U, 1U, 2047U, 2048U, 4095U})
        for (std::uint64_t step = 0; step < 16384; step += batch) {
            Squares64 squares{};
            for (std::size_t i = 0; i < batch; ++i)
                squares[i] =
                    square_of(50 + static_cast<int>(i % 2), index << 14 | (step + i), 26, random());
            ASSERT_NO_FATAL_FAILURE(expect_inverse_sqrt(stages, squares));
        }
}

/// What the model's length() makes of S.
std::int32_t length_of(std::uint64_t squared)
{
    if (squared == 0)
        return 0;
    const InverseSqrt inverse = inverse_sqrt(squared);
    const int zeros = std::countl_zero(squared);
    return static_cast<std::int32_t>((((squared << zeros) >> 32) * inverse.mantissa) >>
                                     (inverse.shift + zeros - 8));
}

TEST_P(MarcherStages, LengthsAreTheModels)
{
    for (int round = 0; round < 100'000; ++round) {
        Squares64 squares{};
        for (std::uint64_t& square : squares)
            square = round == 0 ? 0 : random() >> between(2, 63);
        for (const bool small : {false, true}) {
            if (small)
                for (std::uint64_t& square : squares)
                    square >>= 10;
            Batch found{};
            stages.length(squares, small, found);
            for (std::size_t i = 0; i < batch; ++i)
                ASSERT_EQ(found[i], length_of(squares[i])) << squares[i];
        }
    }
}

RawVector lane(const PointBatch& batch, std::size_t i)
{
    return {batch.x[i], batch.y[i], batch.z[i]};
}

Point as_point(const RawVector& v)
{
    return map(v, [](std::int32_t c) { return Coordinate::from_raw(c); });
}

TEST_P(MarcherStages, NormalisedVectorsOfEveryLength)
{
    for (int round = 0; round < 100'000; ++round) {
        const bool small = round % 2 == 0;
        const int bits = between(0, small ? 25 : 31);
        PointBatch v{};
        for (std::size_t i = 0; i < batch; ++i) {
            // Up to where the squares fill 64 bits, with the axes and the zero vector among them.
            const std::int64_t most =
                std::min<std::int64_t>((std::int64_t{1} << bits) - 1, 1'900'000'000);
            const auto component = [&] {
                return between(0, 4) == 0 ? 0
                                          : between(static_cast<std::int32_t>(-most),
                                                    static_cast<std::int32_t>(most));
            };
            v.x[i] = component();
            v.y[i] = component();
            v.z[i] = component();
        }
        PointBatch found{};
        stages.normalise(v, small, found);
        for (std::size_t i = 0; i < batch; ++i)
            ASSERT_EQ(lane(found, i), raw(normalise(lane(v, i))))
                << v.x[i] << " " << v.y[i] << " " << v.z[i];
    }
}

TEST_P(MarcherStages, PositionsForEvery16BitPieceOfT)
{
    constexpr std::int32_t one = 1 << 24;
    for (const std::int32_t d :
         {one, one + 1, one - 1, 1, 0, 12'345'678, 65'535, 65'536, 8'388'608})
        for (const int shift : {0, 7, 13})
            for (std::int32_t piece = 0; piece < 65'536; piece += batch) {
                PointBatch direction{};
                Batch t{};
                for (std::size_t i = 0; i < batch; ++i) {
                    direction.x[i] = d;
                    direction.y[i] = -d;
                    direction.z[i] = between(-one - 1, one + 1);
                    t[i] = std::min((piece + static_cast<std::int32_t>(i)) << shift,
                                    31 * one); // what a step can have gone
                }
                const Point eye = as_point({16 * one, -16 * one, 5});
                PointBatch found{};
                stages.position(eye, direction, t, found);
                for (std::size_t i = 0; i < batch; ++i) {
                    const Coordinate gone = Coordinate::from_raw(t[i]);
                    const Point expected =
                        eye + map(as_point(lane(direction, i)),
                                  [&](Coordinate c) { return multiply(c, gone); });
                    ASSERT_EQ(lane(found, i), raw(expected)) << d << " times " << t[i];
                }
            }
}

constexpr std::array scenes = {Scene::Sphere, Scene::Cube, Scene::InfiniteCube, Scene::Tunnel};

/// Where folds turn, medians change over and surfaces are, each with its neighbours.
std::vector<std::int32_t> edges()
{
    std::vector<std::int32_t> all;
    for (int shift = 19; shift <= 25; ++shift)
        for (const std::int32_t sign : {-1, 1})
            for (const std::int32_t off : {-1, 0, 1})
                all.push_back(sign * (1 << shift) + off);
    for (const std::int32_t at : {0, 1, -1, 7'549'747, 4'753'489, 3'047'917, 838'861, 167'772,
                                  3 << 24, -(47 << 24), 47 << 24})
        all.push_back(at);
    return all;
}

TEST_P(MarcherStages, DistancesAtEveryCombinationOfEdges)
{
    const std::vector<std::int32_t> values = edges();
    PointBatch p{};
    std::size_t filled = 0;
    for (const std::int32_t x : values)
        for (const std::int32_t y : values)
            for (const std::int32_t z : values) {
                p.x[filled] = x;
                p.y[filled] = y;
                p.z[filled] = z;
                if (++filled < batch)
                    continue;
                filled = 0;
                for (const Scene scene : scenes) {
                    Batch found{};
                    stages.distance(scene, p, found);
                    for (std::size_t i = 0; i < batch; ++i)
                        ASSERT_EQ(found[i], scene_row(scene).distance(as_point(lane(p, i))).raw())
                            << static_cast<int>(scene) << ": " << p.x[i] << " " << p.y[i] << " "
                            << p.z[i];
                }
            }
}

TEST_P(MarcherStages, NormalsAroundTheSurfaces)
{
    for (int round = 0; round < 20'000; ++round) {
        PointBatch p{};
        for (Batch* const component : {&p.x, &p.y, &p.z})
            for (std::int32_t& c : *component)
                c = between(-(1 << 24) / 2, (1 << 24) / 2) * (round % 3 == 0 ? 2 : 1);
        for (const Scene scene : scenes) {
            PointBatch found{};
            stages.surface_normal(scene, p, found);
            for (std::size_t i = 0; i < batch; ++i) {
                const Point at = as_point(lane(p, i));
                ASSERT_EQ(lane(found, i), raw(surface_normal(at, scene_row(scene).distance)))
                    << static_cast<int>(scene) << ": " << p.x[i] << " " << p.y[i] << " " << p.z[i];
            }
        }
    }
}

TEST_P(MarcherStages, BrightnessOfUnitVectors)
{
    constexpr std::int32_t one = (1 << 24) + 1;
    for (int round = 0; round < 20'000; ++round) {
        PointBatch normal{};
        PointBatch light{};
        for (PointBatch* const v : {&normal, &light})
            for (std::size_t i = 0; i < batch; ++i) {
                const Point unit = normalise(
                    {between(-one, one), between(-one, one), round == 0 ? 0 : between(-one, one)});
                v->x[i] = unit.x.raw();
                v->y[i] = unit.y.raw();
                v->z[i] = unit.z.raw();
            }
        Batch found{};
        stages.brightness(normal, light, found);
        for (std::size_t i = 0; i < batch; ++i)
            ASSERT_EQ(found[i],
                      brightness(as_point(lane(normal, i)), as_point(lane(light, i))).raw());
    }
}

TEST_P(MarcherStages, ShadesOfEveryColour)
{
    constexpr std::int32_t darkest = 1 << 21;
    constexpr std::int32_t brightest = (1 << 24) + 4;
    for (std::uint16_t c = 0; c < 1024; ++c)
        for (int round = 0; round < 64; ++round) {
            const std::array<std::uint16_t, 3> colour = {c, static_cast<std::uint16_t>(1023 - c),
                                                         static_cast<std::uint16_t>(c ^ 341)};
            Batch bright{};
            for (std::int32_t& b : bright)
                b = between(darkest, brightest);
            bright[0] = darkest;
            bright[1] = brightest;
            Batch found{};
            stages.shade(colour, bright, found);
            for (std::size_t i = 0; i < batch; ++i) {
                const auto rgb = shade(colour, Coordinate::from_raw(bright[i]));
                ASSERT_EQ(found[i], rgb[0] | rgb[1] << 8 | rgb[2] << 16) << c << " " << bright[i];
            }
        }
}

TEST_P(MarcherStages, CompactionKeepsTheOrderForEverySet)
{
    std::size_t lanes = 1;
    for (std::uint32_t chosen = 0; chosen < std::uint32_t{1} << lanes; ++chosen) {
        Batch numbers{};
        for (std::size_t i = 0; i < batch; ++i)
            numbers[i] = static_cast<std::int32_t>(i);
        const std::size_t count = stages.compact(chosen, numbers, lanes);
        std::vector<std::int32_t> expected;
        for (const std::uint32_t wanted : {1U, 0U})
            for (std::size_t i = 0; i < lanes; ++i)
                if ((chosen >> i & 1) == wanted)
                    expected.push_back(static_cast<std::int32_t>(i));
        ASSERT_TRUE(std::ranges::equal(expected, std::span(numbers).first(lanes))) << chosen;
        ASSERT_EQ(count, static_cast<std::size_t>(
                             std::popcount(chosen & ((std::uint64_t{1} << lanes) - 1))));
    }
}

INSTANTIATE_TEST_SUITE_P(Identity, MarcherStages, testing::ValuesIn(stages_here()),
                         [](const auto& of) { return std::string(name_of(of.param.isa)); });

} // namespace
} // namespace raymarch::engine::marcher::fast

#endif
