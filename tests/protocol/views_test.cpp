// SPDX-License-Identifier: MIT
#include "protocol/views.hpp"

#include "protocol/accelerators.hpp"
#include "tests/fakes/descriptions.hpp"

#include <gtest/gtest.h>

#include <array>
#include <optional>

namespace raymarch::protocol
{
namespace
{

TEST(Views, ScenesComeRoundAndNothingElseChanges)
{
    State state = initial_state(marcher::description);
    state.codes[marcher::ZM] = 12345;
    std::optional<std::size_t> shown;
    for (const std::int64_t scene : {1, 2, 3, 0, 1}) {
        state = next_scene(marcher::description, state, shown);
        State expected = initial_state(marcher::description);
        expected.codes[marcher::ZM] = 12345;
        expected.codes[marcher::OBJ] = scene;
        EXPECT_EQ(state, expected);
    }
    EXPECT_FALSE(shown);
}

TEST(Views, FractalHasScenesToo)
{
    std::optional<std::size_t> shown;
    const State state =
        next_scene(fractal::description, initial_state(fractal::description), shown);
    EXPECT_NE(state.codes[fractal::SCENE],
              initial_state(fractal::description).codes[fractal::SCENE]);
}

TEST(Views, WithoutScenesThePresetsComeRound)
{
    const Accelerator& accelerator = whitted::description;
    State state = initial_state(accelerator);
    std::optional<std::size_t> shown;
    for (std::size_t i = 0; i <= accelerator.presets.size(); ++i) {
        state = next_scene(accelerator, state, shown);
        const std::size_t wanted = i % accelerator.presets.size();
        EXPECT_EQ(shown, wanted);
        EXPECT_EQ(state, preset_state(accelerator, accelerator.presets[wanted]));
    }
    shown = accelerator.presets.size() - 2;
    EXPECT_EQ(next_scene(accelerator, state, shown),
              preset_state(accelerator, accelerator.presets.back()));
}

class EveryView : public test::EveryAccelerator
{};
INSTANTIATE_TEST_SUITE_P(Accelerators, EveryView, testing::ValuesIn(accelerators),
                         test::accelerator_name);

TEST_P(EveryView, ASceneIsAChoice)
{
    if (accelerator.scene) {
        EXPECT_TRUE(table[*accelerator.scene].is_choice());
    }
    EXPECT_FALSE(accelerator.presets.empty());
}

TEST(Views, AChannelIsLitFromTheMiddleOfItsRangeOn)
{
    State state = initial_state(marcher::description);
    state.codes[marcher::R] = 512;
    state.codes[marcher::G] = 511;
    state.codes[marcher::B] = 1023;
    EXPECT_EQ(colour_bits(marcher::description, state), (std::array{true, false, true}));
}

TEST(Views, WithoutAColourNothingIsLit)
{
    EXPECT_EQ(colour_bits(fractal::description, initial_state(fractal::description)),
              (std::array{false, false, false}));
}

} // namespace
} // namespace raymarch::protocol
