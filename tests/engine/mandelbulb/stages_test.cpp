// SPDX-License-Identifier: MIT
/// @file
/// The rules that no vector shows: limits, colours, cycles, aspects, and the two forms of dr.
#include "engine/mandelbulb/colouring.hpp"
#include "engine/mandelbulb/mandelbulb.hpp"
#include "engine/mandelbulb/ray_generator.hpp"
#include "engine/mandelbulb/ray_marcher.hpp"
#include "tests/engine/mandelbulb/views.hpp"

#include <gtest/gtest.h>

namespace raymarch::engine::mandelbulb
{
namespace
{

using Narrow = Q57<Int128>;
constexpr std::int64_t unit = std::int64_t{1} << 57;

TEST(MandelbulbRays, TheMiddleOfAnOddPictureIsForward)
{
    const Frame frame{.forward = {unit, 0, 0}, .right = {0, -unit, 0}, .up = {0, 0, unit}};
    EXPECT_EQ(ray_direction(frame, {3, 3}, 1, 1), (Direction{unit, 0, 0}));
    // q = (6, 2, 2) times 2^45, towards zero.
    const Direction corner = ray_direction(frame, {3, 3}, 0, 0);
    EXPECT_EQ(corner.y, corner.z);
    EXPECT_NEAR(static_cast<double>(corner.x) / static_cast<double>(corner.y), 3, 1e-12);
    const Direction opposite = ray_direction(frame, {3, 3}, 2, 2);
    EXPECT_EQ(opposite, (Direction{corner.x, -corner.y, -corner.z}));
}

TEST(MandelbulbRays, ASquarePictureIsAsWideAsHigh)
{
    Frame frame{.forward = {unit, 0, 0}, .right = {0, -unit, 0}, .up = {0, 0, unit}};
    const Direction natural = ray_direction(frame, {8, 4}, 1, 0); // u = -5
    frame.aspect = Aspect::Square;
    const Direction square = ray_direction(frame, {8, 4}, 1, 0); // -5 * 4 / 8 = -2, not -3
    EXPECT_GT(natural.y, square.y);
    EXPECT_NEAR(static_cast<double>(square.y) / static_cast<double>(square.x), 2. / 8, 1e-12);
}

TEST(MandelbulbRays, NoBasisNoRay)
{
    EXPECT_EQ(ray_direction(Frame{}, {8, 8}, 0, 0), Direction{});
}

TEST(MandelbulbMarch, AFrameScaleMovesNothingButTheLimit)
{
    const View view = read_views().front(); // far away: a scale of 1 still reaches the surface
    for (const PixelCheck& pixel : view.pixels) {
        Arithmetic scaled = view.frame.arithmetic;
        scaled.scale = 1;
        const Point<Narrow> origin = position_in<Narrow>(view.frame.position);
        const March<Narrow> far = march<Narrow>(origin, pixel.direction, scaled, {});
        EXPECT_EQ(far.outcome, Outcome::Hit);
        EXPECT_NEAR(static_cast<double>(far.t) / 2, static_cast<double>(pixel.t), 1e-6 * unit);
        scaled.scale = 3; // one unit is all that a ray may go
        EXPECT_EQ(march<Narrow>(origin, pixel.direction, scaled, {}).outcome, Outcome::Miss);
    }
}

TEST(MandelbulbMarch, FewerEvaluationsEndAtTheLimit)
{
    const View view = read_views().front();
    const PixelCheck& pixel = view.pixels.front();
    const March<Narrow> ray =
        march<Narrow>(position_in<Narrow>(view.frame.position), pixel.direction,
                      view.frame.arithmetic, {.evaluations = pixel.evaluations - 1});
    EXPECT_EQ(ray.outcome, Outcome::Limit);
    EXPECT_EQ(ray.evaluations, pixel.evaluations - 1);
}

TEST(MandelbulbMarch, InsideTheFirstEvaluationHits)
{
    const March<Narrow> ray = march<Narrow>({}, {unit, 0, 0}, {}, {});
    EXPECT_EQ(ray.outcome, Outcome::Hit);
    EXPECT_EQ(ray.evaluations, 1);
    EXPECT_EQ(ray.index, 24);
    EXPECT_EQ(ray.t, 0);
}

TEST(MandelbulbDerivative, SlidesWhereTheSourceSaturates)
{
    const Derivative large{~std::uint64_t{0}, 32};
    const auto next = [&](DerivativeForm form) {
        return next_derivative<Narrow>(large, unit, 8, all_bits, form);
    };
    EXPECT_EQ(next(DerivativeForm::Saturating), large);
    // 8 * (2^64 - 1) + 2^32 = 2^67 + 2^32 - 8, four bits too long.
    EXPECT_EQ(next(DerivativeForm::Sliding),
              (Derivative{(std::uint64_t{1} << 63) + (std::uint64_t{1} << 28) - 1, 28}));
}

TEST(MandelbulbColours, BySteps)
{
    EXPECT_EQ(colour_of(ColourMode::Steps, 1, 9), step_colours[1]);
    EXPECT_EQ(colour_of(ColourMode::Steps, 5, 9), step_colours[2]);
    EXPECT_EQ(colour_of(ColourMode::Steps, 62, 9), step_colours[31]);
    EXPECT_EQ(colour_of(ColourMode::Steps, 200, 9), step_colours[31]);
}

TEST(MandelbulbColours, ByIndexTwentyFourAndAgain)
{
    EXPECT_EQ(colour_of(ColourMode::Index, 9, 0), index_colours[1]);
    EXPECT_EQ(colour_of(ColourMode::Index, 9, 1), index_colours[1]);
    EXPECT_EQ(colour_of(ColourMode::Index, 9, 24), index_colours[24]);
    EXPECT_EQ(colour_of(ColourMode::Index, 9, 25), index_colours[1]);
    EXPECT_EQ(colour_of(ColourMode::Index, 9, 63), index_colours[15]);
}

TEST(MandelbulbFrame, KeptBitsByThemselves)
{
    EXPECT_EQ(automatic_kept_bits(9), 17);
    EXPECT_EQ(automatic_kept_bits(32), 36);
    EXPECT_EQ(automatic_kept_bits(57), 61);
    EXPECT_EQ(automatic_kept_bits(64), 64);
}

TEST(MandelbulbFrame, ThePositionIsFloored)
{
    const Position position{Int128(-1), Int128(127), Int128(128)};
    EXPECT_EQ(position_in<Narrow>(position), (Point<Narrow>{-1, 0, 1}));
}

TEST(MandelbulbCycles, FivePassesOfAFullPipeline)
{
    Frame frame{};
    const std::vector<PixelCost> costs(1000, {.steps = 20, .rays = 1});
    EXPECT_EQ(frame_cycles(frame, {}, costs, 1), 5U * (20'000 + 1096));
    EXPECT_EQ(frame_cycles(frame, {}, costs, 3), 5U * (6'667 + 1096));
    frame.arithmetic.steps = 23; // "we started at 900"
    frame.arithmetic.iterations = 31;
    EXPECT_EQ(frame_cycles(frame, {}, costs, 1), 7U * (20'000 + 898));
}

TEST(MandelbulbPicture, ARowIsItsPixels)
{
    const View view = read_views().front();
    std::vector<std::uint8_t> pixels(16 * 3);
    std::vector<PixelCost> costs(16);
    for (const ColourMode mode : {ColourMode::Steps, ColourMode::Index}) {
        Frame frame = view.frame;
        frame.colour = mode;
        draw_row(frame, {{16, 9}, 4, 0}, pixels, costs);
        int misses = 0;
        for (std::uint16_t x = 0; x < 16; ++x) {
            const March<Narrow> ray =
                march<Narrow>(position_in<Narrow>(frame.position),
                              ray_direction(frame, {16, 9}, x, 4), frame.arithmetic, {});
            const bool miss = ray.outcome == Outcome::Miss;
            const Rgb colour = miss ? 0x05070c : colour_of(mode, ray.evaluations, ray.index);
            EXPECT_EQ(pixels[3 * x] << 16 | pixels[3 * x + 1] << 8 | pixels[3 * x + 2],
                      static_cast<int>(colour));
            EXPECT_EQ(costs[x].steps, static_cast<std::uint32_t>(ray.evaluations));
            EXPECT_EQ(costs[x].rays, 1U);
            misses += miss ? 1 : 0;
        }
        EXPECT_GT(misses, 0);
        EXPECT_LT(misses, 16);
    }
}

} // namespace
} // namespace raymarch::engine::mandelbulb
