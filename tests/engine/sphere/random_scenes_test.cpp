// SPDX-License-Identifier: MIT
/// @file
/// Random scenes over the designs' whole ranges, against a second implementation of the originals.
#include "tests/engine/sphere/reference.hpp"

#include "engine/sphere/prototype_pixel.hpp"
#include "engine/sphere/rtl_pixel.hpp"
#include "tests/fakes/random.hpp"

#include <gtest/gtest.h>

#include <map>

#if defined(__SIZEOF_INT128__)

namespace raymarch::engine::sphere
{
namespace
{

/// Coordinates from `low` to `high`, mostly near a pixel's line so that there is something to hit.
class Scenes
{
  public:
    Scenes(std::int32_t low, std::int32_t high) : low_(low), high_(high) {}

    Frame next(Design design)
    {
        Frame frame;
        frame.design = design;
        frame.eye = near_or_far({320, 240, 0});
        frame.screen = number(1000);
        frame.calibration = test::pick(random_, 0, 1023);
        frame.derounder = test::pick(random_, 1, 200);
        frame.ball_count = test::pick<std::size_t>(random_, 0, max_balls);
        frame.light_count = test::pick<std::size_t>(random_, 0, max_lights);
        for (Ball& ball : frame.balls)
            ball = {near_or_far({320, 240, 1000}),
                    test::pick(random_, 0, high_) >> test::pick(random_, 0, 12)};
        for (Light& light : frame.lights)
            light = {near_or_far({50, 50, 1000}), test::pick(random_, 0, 65'535)};
        if (design == Design::Prototype)
            frame.shadow = test::pick(random_, 0, 255);
        return frame;
    }

    int pixel(int end) { return test::pick(random_, 0, end - 1); }

  private:
    std::int32_t number(std::int32_t middle)
    {
        const int spread = high_ >> test::pick(random_, 0, 10);
        return test::pick(random_, std::max(low_, middle - spread),
                          std::min(high_, middle + spread));
    }
    Point near_or_far(const Point& middle)
    {
        return {number(middle.x), number(middle.y), number(middle.z)};
    }

    std::mt19937_64 random_ = test::seeded_random();
    std::int32_t low_;
    std::int32_t high_;
};

TEST(SphereRandomScenes, TheHardware)
{
    Scenes scenes(0, 65'535);
    std::map<int, int> outcomes_seen;
    for (int i = 0; i < 20'000; ++i) {
        const Frame frame = scenes.next(Design::Rtl);
        for (int j = 0; j < 4; ++j) {
            const int x = scenes.pixel(1920);
            const int y = scenes.pixel(1080);
            const reference::HardwarePixel expected = reference::hardware(frame, x, y);
            const RtlPixel pixel = rtl_pixel(frame, x, y);
            ASSERT_EQ(pixel.value, expected.value) << "scene " << i << " at " << x << ' ' << y;
            ASSERT_EQ(row_of(pixel.outcome).period, expected.edges) << i;
            ++outcomes_seen[expected.edges];
        }
    }
    for (const int edges : {1008, 4608, 6108, 7012})
        EXPECT_GT(outcomes_seen[edges], 100) << edges;
}

/// The prototype's range: differences up to 18,900.
TEST(SphereRandomScenes, ThePrototype)
{
    Scenes scenes(-5'000, 5'000);
    int lit = 0;
    for (int i = 0; i < 20'000; ++i) {
        const Frame frame = scenes.next(Design::Prototype);
        for (int j = 0; j < 4; ++j) {
            const int x = scenes.pixel(640);
            const int y = scenes.pixel(480);
            const std::array<int, 3> expected = reference::prototype(frame, x, y);
            const std::array<std::uint8_t, 3> colour = prototype_pixel(frame, x, y).colour;
            ASSERT_EQ((std::array<int, 3>{colour[0], colour[1], colour[2]}), expected)
                << "scene " << i << " at " << x << ' ' << y;
            lit += expected[0] > frame.shadow ? 1 : 0;
        }
    }
    EXPECT_GT(lit, 300);
}

} // namespace
} // namespace raymarch::engine::sphere

#endif
