// SPDX-License-Identifier: MIT
/// @file
/// The stages of the fractal's kernels by themselves, on all that their arguments can be, in every
/// instruction set that runs here.
#include "engine/fast/targets.hpp"
#include "engine/fractal/inverse_sqrt.hpp"
#include "engine/fractal/scenes.hpp"
#include "engine/fractal/shading.hpp"
#include "engine/isa.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <random>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "tests/identity/fractal_stages_test.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>
#if HWY_TARGET != HWY_SCALAR && HWY_TARGET != HWY_EMU128
#include "engine/fractal/fast/inverse_sqrt-inl.hpp"
#include "engine/fractal/fast/scenes-inl.hpp"
#include "engine/fractal/fast/shading-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace raymarch::engine::fractal::fast::HWY_NAMESPACE
{

constexpr std::int32_t words = 1 << Number::width;
#ifdef NDEBUG
constexpr std::int32_t stride = 1;
#else
constexpr std::int32_t stride = 13; // a build that is not optimised looks at some
#endif

/// Of the words that it takes.
void expect_inverse_sqrt()
{
    for (std::int32_t a = least_radicand; a < words; a += lanes<I32>) {
        std::array<std::int32_t, lanes<I32>> roots{};
        hn::StoreU(inverse_sqrt(hn::Iota(I32(), a)), I32(), roots.data());
        for (std::size_t lane = 0; lane < lanes<I32>; ++lane) {
            const auto at = static_cast<std::int32_t>(a + static_cast<std::int32_t>(lane));
            ASSERT_EQ(roots[lane], fractal::inverse_sqrt(word(at)).raw()) << at;
        }
    }
}

/// Of the bits that it looks at: 13 of a position in each axis, of which x and z count by their
/// sum; of the depth all.
void expect_brick()
{
    const U16 d;
    std::mt19937 random(1); // NOLINT(cert-msc51-cpp)
    for (std::int32_t y = 0; y < 1 << 13; y += stride)
        for (std::int32_t x = 0; x < 1 << 13; x += lanes<U16> * 8) {
            const auto z = static_cast<std::int32_t>(random() % words);
            const std::int32_t depth = y % 32;
            std::array<std::uint16_t, lanes<U16>> shaded{};
            hn::StoreU(brick(d, hn::Iota(d, static_cast<std::uint16_t>(x)), Set<U16>(y),
                             Set<U16>(z), Set<U16>(depth)),
                       d, shaded.data());
            for (std::size_t lane = 0; lane < lanes<U16>; ++lane) {
                const auto at = static_cast<std::int32_t>(x + static_cast<std::int32_t>(lane));
                ASSERT_EQ(shaded[lane], fractal::brick({word(at), word(y), word(z)},
                                                       static_cast<std::uint8_t>(depth)))
                    << at << " " << y << " " << z;
            }
        }
}

/// The distance of every word in x, and behind a step of every kind from there: `largest` is the
/// longest step of the scene.
template <class Rays>
void expect_distance(Distance distance, std::int32_t largest, bool words_wrap)
{
    using Tag = typename Rays::Tag;
    using Lane = hn::TFromD<Tag>;
    const auto first_lane = [](Vec<Tag> v) { return static_cast<std::int32_t>(hn::GetLane(v)); };
    std::mt19937 random(2); // NOLINT(cert-msc51-cpp)
    const auto between = [&](std::int32_t low, std::int32_t high) {
        return std::uniform_int_distribution<std::int32_t>(low, high)(random);
    };
    const std::int32_t reach = words_wrap ? words / 2 : 11 << 15; // the cube's rays
    for (std::int32_t x = -reach; x < reach; x += stride) {
        const Point p{word(x), word(between(-reach, reach - 1)), word(between(-reach, reach - 1))};
        Rays rays;
        rays.start(p);
        const auto at_least_0 = [&](const Point& at) {
            const std::int32_t s = distance(at).raw();
            return words_wrap ? std::max(s, 0) : s;
        };
        ASSERT_EQ(first_lane(rays.distance()), at_least_0(p)) << x;

        const auto component = [&] {
            const std::int32_t edge = between(-1, 1) * (longest - 1);
            return between(0, 3) == 0 ? edge : between(1 - longest, longest - 1);
        };
        const Point direction{word(component()), word(component()), word(component())};
        const std::int32_t s = between(0, 3) == 0 ? largest : between(hit_limit.raw(), largest);
        std::array<Directions, Rays::parts> to;
        to.fill({Set<I32>(direction.x.raw()), Set<I32>(direction.y.raw()),
                 Set<I32>(direction.z.raw())});
        rays.aim(to);
        rays.step(Set<Tag>(s));
        const Point next = p + map(direction, [&](Number c) { return multiply(c, word(s)); });
        ASSERT_EQ(first_lane(rays.distance()), at_least_0(next)) << x << " " << s;
    }
}

void expect_stages()
{
    expect_inverse_sqrt();
    expect_brick();
    expect_distance<MengerRays>(menger, 36044, true);
    expect_distance<CubesRays>(cubes, quarter.raw(), true);
    expect_distance<MazeRays>(maze, half.raw() - sixteenth.raw(), true);
    expect_distance<CubeRays>(cube, five.raw(), false);
}

} // namespace raymarch::engine::fractal::fast::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif

#if HWY_ONCE
namespace raymarch::engine::fractal::fast
{
namespace
{

struct Stages
{
    Isa isa;
    void (*expect)();
};
constexpr std::array compiled = {
    Stages{Isa::Sse4, HWY_CHOOSE_SSE4(expect_stages)},
    Stages{Isa::Neon, HWY_CHOOSE_NEON(expect_stages)},
    Stages{Isa::Avx2, HWY_CHOOSE_AVX2(expect_stages)},
    Stages{Isa::Avx512, HWY_CHOOSE_AVX3(expect_stages)},
};

TEST(FractalStages, AreTheReferencesOnAllArguments)
{
    for (const Stages& stages : compiled)
        if (stages.expect != nullptr && supported(stages.isa)) {
            SCOPED_TRACE(name_of(stages.isa));
            stages.expect();
        }
}

} // namespace
} // namespace raymarch::engine::fractal::fast
#endif
