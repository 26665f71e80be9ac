// SPDX-License-Identifier: MIT
#include "engine/draw.hpp"
#include "engine/fractal/frame.hpp"
#include "engine/models.hpp"
#include "protocol/accelerators/fractal.hpp"
#include "protocol/assignments.hpp"
#include "protocol/registers.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <set>

namespace raymarch::engine::fractal
{
namespace
{

namespace table = protocol::fractal;

TEST(FractalPresets, StandInFreeSpaceAndShowSomething)
{
    std::array<int, table::scenes.size()> views{};
    std::set<std::string_view> names;
    for (const protocol::Preset& preset : table::presets) {
        protocol::State state = protocol::initial_state(table::description);
        protocol::ParameterSet given;
        EXPECT_FALSE(protocol::read_assignments(table::description, {.bytes = preset.settings},
                                                state, given))
            << preset.name;
        EXPECT_TRUE(names.insert(preset.name).second) << preset.name;
        EXPECT_FALSE(preset.summary.empty()) << preset.name;

        const protocol::Words words = protocol::pack(table::description, state);
        const Frame frame = latch(words);
        ++views[static_cast<std::size_t>(frame.scene)];
        EXPECT_GT(scene_row(frame.scene).distance(frame.position), hundredth) << preset.name;
        Image image({64, 48});
        Painter painter(1);
        draw_still(painter, {model_of(table::description), words}, image);
        const auto [darkest, brightest] = std::ranges::minmax(image.rgb);
        EXPECT_GT(brightest - darkest, 150) << preset.name;
    }
    for (const int count : views)
        EXPECT_GE(count, 3);
}

} // namespace
} // namespace raymarch::engine::fractal
