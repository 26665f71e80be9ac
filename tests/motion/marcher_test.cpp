// SPDX-License-Identifier: MIT
#include "motion/marcher.hpp"

#include "motion/movers.hpp"
#include "protocol/accelerators/marcher.hpp"
#include "protocol/assignments.hpp"

#include <gtest/gtest.h>

namespace raymarch::motion::marcher
{
namespace
{

namespace table = protocol::marcher;

protocol::State after(std::string_view settings, Inputs inputs, int steps)
{
    protocol::State state = protocol::initial_state(table::description);
    protocol::ParameterSet given;
    EXPECT_FALSE(protocol::read_assignments(table::description, {.bytes = settings}, state, given));
    const auto mover = mover_of(table::description);
    for (int i = 0; i < steps; ++i)
        mover->step(state, inputs);
    return state;
}

TEST(MarcherMotion, AFullTurnEndsWhereItBegan)
{
    for (const Input input : {Input::TurnLeft, Input::TurnRight, Input::Animate})
        EXPECT_EQ(after("ZM=2", input, 360), after("ZM=2", Input::Forward, 0));
}

TEST(MarcherMotion, TurningRightLooksFromTheRight)
{
    const protocol::State state = after("ZM=2", Input::TurnRight, 90);
    EXPECT_NEAR(static_cast<double>(state.codes[table::FX]), 131072, 1); // from +x
    EXPECT_NEAR(static_cast<double>(state.codes[table::FZ]), 0, 1);
    EXPECT_NEAR(static_cast<double>(state.codes[table::RZ]), -131072, 1);
}

TEST(MarcherMotion, TheCameraStopsShortOfThePoles)
{
    const protocol::State high = after("ZM=2", Input::TurnUp, 200);
    EXPECT_EQ(high, after("ZM=2", Input::TurnUp, 89));
    EXPECT_LT(high.codes[table::FY], 131'072);
}

TEST(MarcherMotion, TheDistanceStaysInItsRange)
{
    EXPECT_EQ(after("ZM=2", Input::Forward, 1).codes[table::ZM], (2 << 24) - (1 << 19));
    EXPECT_EQ(after("ZM=2", Input::Forward, 1000).codes[table::ZM], 0);
    EXPECT_EQ(after("ZM=2", Input::Back, 1000).codes[table::ZM], 10 << 24);
}

TEST(MarcherMotion, OppositeInputsCancel)
{
    const World world{.yaw = 10, .pitch = 20, .zoom = 1 << 24};
    EXPECT_EQ(step(world, Inputs(Input::TurnLeft) | Input::TurnRight | Input::Up | Input::Down |
                              Input::Forward | Input::Back),
              world);
    EXPECT_EQ(step(world, {}), world);
}

TEST(MarcherMotion, AHostsChangeIsTakenUp)
{
    protocol::State state = protocol::initial_state(table::description);
    const auto mover = mover_of(table::description);
    mover->step(state, Input::TurnRight);
    state.codes[table::ZM] = 1 << 24;
    mover->step(state, Input::TurnRight);
    EXPECT_EQ(state.codes[table::ZM], 1 << 24);
    // The angle was read back from rounded codes.
    const protocol::State expected = after("ZM=1", Input::TurnRight, 2);
    for (const std::size_t i : {table::FX, table::FZ, table::RX, table::RZ})
        EXPECT_NEAR(static_cast<double>(state.codes[i]), static_cast<double>(expected.codes[i]), 2);
}

} // namespace
} // namespace raymarch::motion::marcher
