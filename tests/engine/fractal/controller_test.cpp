// SPDX-License-Identifier: MIT
// Against the controller's rules acted out clock by clock, as slow as they read.
#include "engine/fractal/controller.hpp"

#include "engine/fractal/checkerboard.hpp"
#include "tests/fakes/random.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace raymarch::engine::fractal
{
namespace
{

std::uint64_t acted_out(const Frame& frame, RowOf last, const std::vector<PixelCost>& costs,
                        unsigned units)
{
    std::vector<std::uint64_t> idle_from(units, 0);
    unsigned x = 0;
    unsigned y = 0;
    for (std::uint64_t clock = 0;; ++clock) {
        if (y == last.size.height) {
            if (std::ranges::all_of(idle_from, [&](std::uint64_t c) { return c <= clock; }))
                return clock + 1;
        } else if (x == last.size.width) {
            x = 0;
            ++y;
        } else if (std::uint64_t& unit = idle_from[clock % units]; unit <= clock) {
            const PixelCost& cost = costs[std::size_t{y} * last.size.width + x];
            if (!frame.checker || in_half(last.frame, x, y))
                unit = clock + 20 + cost.steps * (scene_row(frame.scene).latency + 1U);
            ++x;
        }
    }
}

TEST(Controller, DoesWhatItsRulesSay)
{
    std::mt19937_64 random = raymarch::test::seeded_random();
    for (int i = 0; i < 600; ++i) {
        const PictureSize size{raymarch::test::pick<std::uint16_t>(random, 1, 40),
                               raymarch::test::pick<std::uint16_t>(random, 1, 6)};
        std::vector<PixelCost> costs(std::size_t{size.width} * size.height);
        const std::uint32_t most = i % 3 == 0 ? 32 : 3;
        for (PixelCost& cost : costs)
            cost = {raymarch::test::pick<std::uint32_t>(random, 1, most), 1};
        const Frame frame{.scene = static_cast<Scene>(i % 4), .checker = i % 2 != 0};
        const RowOf last{size, static_cast<std::uint16_t>(size.height - 1),
                         raymarch::test::pick<std::uint32_t>(random, 0, 3)};
        const unsigned units =
            i % 10 == 0 ? 255 : raymarch::test::pick<std::uint32_t>(random, 1, 40);
        EXPECT_EQ(frame_cycles(frame, last, costs, units), acted_out(frame, last, costs, units))
            << size.width << 'x' << size.height << ", " << units << " units";
    }
}

} // namespace
} // namespace raymarch::engine::fractal
