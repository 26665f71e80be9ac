// SPDX-License-Identifier: MIT
#include "engine/marcher/frame.hpp"

#include "protocol/accelerators.hpp"
#include "protocol/registers.hpp"

#include <gtest/gtest.h>

namespace raymarch::engine::marcher
{
namespace
{

namespace table = protocol::marcher;

protocol::State initial()
{
    return protocol::initial_state(table::description);
}

Frame latch_state(const protocol::State& state)
{
    return latch(protocol::pack(table::description, state));
}

TEST(Frame, TheDefaults)
{
    const Frame frame = latch_state(initial());
    EXPECT_EQ(frame.forward, (RawVector{0, 0, 131071}));
    EXPECT_EQ(frame.right, (RawVector{131071, 0, 0}));
    EXPECT_EQ(frame.up, (RawVector{0, 131071, 0}));
    EXPECT_EQ(raw(frame.eye), (RawVector{0, 0, 50'331'264})); // 3 * 2^24 * (1 - 2^-17)
    EXPECT_EQ(raw(frame.light), (RawVector{3 << 24, 2 << 24, 5 << 24}));
    EXPECT_EQ(frame.colour, (std::array<std::uint16_t, 3>{1023, 1023, 1023}));
    EXPECT_EQ(frame.scene, Scene::Sphere);
}

TEST(Frame, NegativeFieldsAreSignExtended)
{
    protocol::State state = initial();
    state.codes[table::FX] = -131072;
    state.codes[table::FY] = -1;
    state.codes[table::ZM] = 1 << 24;
    state.codes[table::LX] = -512;
    state.codes[table::LY] = -1;
    const Frame frame = latch_state(state);
    EXPECT_EQ(frame.forward, (RawVector{-131072, -1, 131071}));
    EXPECT_EQ(frame.eye.x.raw(), -(1 << 24));
    EXPECT_EQ(frame.eye.y.raw(), -128); // -2^-17
    EXPECT_EQ(frame.light.x.raw(), -(64 << 24));
    EXPECT_EQ(frame.light.y.raw(), -(1 << 21)); // -1/8
}

TEST(Frame, TheEyeIsFloored)
{
    protocol::State state = initial();
    state.codes[table::FX] = -1;
    state.codes[table::FY] = 1;
    state.codes[table::ZM] = 1;
    const Frame frame = latch_state(state);
    EXPECT_EQ(frame.eye.x.raw(), -1); // -2^-17 of a raw
    EXPECT_EQ(frame.eye.y.raw(), 0);
}

TEST(Frame, AZoomAbove16CountsAs16)
{
    for (const std::int64_t zoom :
         {std::int64_t{16} << 24, (std::int64_t{16} << 24) + 1, std::int64_t{0xFFFF'FFFF}}) {
        protocol::State state = initial();
        state.codes[table::FX] = -131072;
        state.codes[table::ZM] = zoom;
        EXPECT_EQ(latch_state(state).eye.x.raw(), -(16 << 24)) << zoom;
    }
}

} // namespace
} // namespace raymarch::engine::marcher
