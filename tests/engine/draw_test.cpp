// SPDX-License-Identifier: MIT
#include "engine/draw.hpp"

#include "engine/models.hpp"
#include "protocol/assignments.hpp"
#include "protocol/registers.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <stop_token>
#include <string>

namespace raymarch::engine
{
namespace
{

namespace table = protocol::marcher;

// Constants in every build, those of the sanitizers too.
static_assert(model_of(table::description).kernels == &marcher::fast::kernels);
static_assert(&model_of(protocol::whitted::description) == &models[4]);

protocol::Words words_of(std::string_view settings)
{
    protocol::State state = protocol::initial_state(table::description);
    protocol::ParameterSet given;
    EXPECT_FALSE(protocol::read_assignments(table::description, {.bytes = settings}, state, given));
    return protocol::pack(table::description, state);
}

TEST(Draw, TheSameBytesForAnyNumberOfThreads)
{
    for (const protocol::Preset& preset : table::presets) {
        const protocol::Words words = words_of(preset.settings);
        Image expected({31, 23});
        const std::vector<PixelCost> costs = draw(models[0], words, expected, 1);
        EXPECT_TRUE(std::ranges::all_of(costs, [](PixelCost cost) { return cost.steps > 0; }));
        for (const unsigned threads : {2U, 3U, 5U, 0U}) {
            Image image({31, 23});
            EXPECT_EQ(draw(models[0], words, image, threads), costs) << preset.name;
            EXPECT_EQ(image.rgb, expected.rgb) << preset.name << " by " << threads;
        }
    }
}

TEST(Draw, EveryPresetShowsSomething)
{
    for (const protocol::Preset& preset : table::presets) {
        Image image({64, 48});
        draw(models[0], words_of(preset.settings), image, 0);
        const auto [darkest, brightest] = std::ranges::minmax(image.rgb);
        EXPECT_GT(brightest - darkest, 30) << preset.name;
    }
}

TEST(Draw, CyclesAreSharedOutAmongTheRayUnits)
{
    // A camera inside the sphere: each ray hits at its first query, 5 cycles; 6 rays by 4
    // units: 7.5.
    Image image({3, 2});
    const protocol::Words words = words_of("ZM=0");
    const std::vector<PixelCost> costs = draw(models[0], words, image, 1);
    EXPECT_EQ(frame_cycles(models[0], words, image.size, 0, costs), 8U);
}

TEST(Draw, ASphereFillsTheMiddleAndNotTheCorners)
{
    Image image({41, 31});
    draw(models[0], words_of("OBJ=sphere"), image, 1);
    const auto red = [&](std::size_t x, std::size_t y) { return image.row(y)[3 * x]; };
    EXPECT_GT(red(20, 15), 0);
    EXPECT_EQ(red(0, 0), 0); // a miss is black
    EXPECT_EQ(red(40, 30), 0);
}

TEST(Draw, AStopLeavesThePictureUnfinished)
{
    std::stop_source stop;
    stop.request_stop();
    Image image({8, 6});
    EXPECT_EQ(draw(models[0], words_of("ZM=0"), image, 2, 0, stop.get_token()),
              std::vector<PixelCost>(48));
    EXPECT_EQ(image.rgb, Image({8, 6}).rgb);
}

TEST(Models, EachDescriptionHasItsModel)
{
    ASSERT_EQ(models.size(), protocol::accelerators.size());
    for (const protocol::Accelerator* accelerator : protocol::accelerators)
        EXPECT_EQ(model_of(*accelerator).description, accelerator) << accelerator->name;
}

} // namespace
} // namespace raymarch::engine
