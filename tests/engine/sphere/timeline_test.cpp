// SPDX-License-Identifier: MIT
#include "engine/sphere/timeline.hpp"

#include "tests/engine/sphere/drawing.hpp"

#include <gtest/gtest.h>

#include <array>

namespace raymarch::engine::sphere
{
namespace
{

/// Edge 1 is phase 0; a value is written at phase 1, two edges before the next enable.
TEST(SphereTimeline, PeriodsFollowFromTheFourPhases)
{
    for (std::size_t i = 0; i < outcomes.size(); ++i) {
        const OutcomeRow& row = outcomes[i];
        EXPECT_EQ(&row_of(row.outcome), &row) << i;
        EXPECT_EQ(&row_of_period(row.period), &row) << i;
        std::uint64_t edge = first_enable + row.ready;
        ASSERT_NE((edge - 1) % 4, 2U) << "ready would be seen by the enable, before the write";
        while ((edge - 1) % 4 != 1)
            ++edge;
        EXPECT_EQ(edge + 2 - first_enable, row.period) << i;
    }
}

TEST(SphereTimeline, TheDividerIsInTimeForHalfOfTheEdges)
{
    const OutcomeRow& clear = row_of(Outcome::LitClear);
    // Set at enable + 4541; loads at edges that leave 64 in 128.
    EXPECT_TRUE(divider_in_time(4608 - 4541 + 64, clear)); // a load at that very edge is in time
    EXPECT_FALSE(divider_in_time(4608 - 4541 + 65, clear));
    EXPECT_FALSE(divider_in_time(4608 - 4541 + 128, clear)); // loads as it is read: too late
    EXPECT_TRUE(divider_in_time(4608 - 4541 + 129, clear));
    for (std::uint64_t enable = first_enable; enable < 4096; enable += 4)
        EXPECT_EQ(divider_in_time(enable, clear), divider_in_time(enable + clear.period, clear))
            << "a run of lit pixels is all in time or all late";
}

struct FrameRow
{
    int missed;
    int lit;
    int shadowed;
    std::uint64_t edges;
};

constexpr std::array frame_rows = {
    FrameRow{307'200, 0, 0, 309'657'600},           //
    FrameRow{281'018, 11'350, 14'832, 439'568'928}, //
    FrameRow{267'695, 23'748, 15'757, 489'755'428}, //
    FrameRow{275'977, 21'356, 9'867, 445'780'668},  //
    FrameRow{0, 307'200, 0, 1'415'577'600},         //
    FrameRow{0, 0, 307'200, 2'154'086'400},         //
};

TEST(SphereTimeline, FramesTakeTheSumOfTheirPixels)
{
    for (const FrameRow& row : frame_rows) {
        std::vector<PixelCost> costs;
        const auto add = [&](int count, Outcome outcome) {
            costs.insert(costs.end(), static_cast<std::size_t>(count),
                         PixelCost{row_of(outcome).period, row_of(outcome).rays});
        };
        add(row.missed, Outcome::Missed);
        add(row.lit, Outcome::LitClear);
        add(row.shadowed, Outcome::Shadowed);
        EXPECT_EQ(frame_cycles(Frame{}, {}, costs, 1), row.edges);
    }
}

TEST(SphereTimeline, ABlackFrameOfTheHardware)
{
    Frame frame;
    frame.balls[0].radius = 0;
    frame.design = Design::RtlTimed;
    const Drawing drawing = draw_frame(frame);
    EXPECT_EQ(frame_cycles(frame, {}, drawing.costs, 1), 309'657'600U);
    EXPECT_EQ(drawing.image.rgb, Image(source_size).rgb);
}

/// Pixels as if drawn, each its own shade, and what the frame buffer makes of them.
std::vector<int> written(Design design, const std::vector<Outcome>& drawn)
{
    Frame frame;
    frame.design = design;
    Image image({static_cast<std::uint16_t>(drawn.size()), 1});
    std::vector<PixelCost> costs;
    for (std::size_t i = 0; i < drawn.size(); ++i) {
        image.rgb[3 * i] = static_cast<std::uint8_t>(i + 1);
        costs.push_back({row_of(drawn[i]).period, row_of(drawn[i]).rays});
    }
    finish(frame, {image.rgb, costs});
    std::vector<int> shades;
    for (std::size_t i = 0; i < drawn.size(); ++i)
        shades.push_back(image.rgb[3 * i]);
    return shades;
}

TEST(SphereTimeline, WhatTheFrameBufferHolds)
{
    using enum Outcome;
    EXPECT_EQ(written(Design::Rtl, {LitClear, Missed, Shadowed}), (std::vector{1, 2, 3}));
    EXPECT_EQ(written(Design::RtlTop, {LitClear, Missed, Shadowed}), (std::vector{0, 1, 2}));

    // Enables at 4, 4612, …: the divider is set at 4545, 65 past a multiple of 128, and late; a
    // first quotient is then 0, and later ones those of the pixel before. A miss shifts them by
    // 1008: from 4612 to 5620, so 5620 + 4541 = 10161 is 49 past a multiple, and in time.
    EXPECT_EQ(written(Design::RtlTimed, {LitClear, LitClear, LitClear, Missed, Missed}),
              (std::vector{0, 0, 1, 2, 4}));
    EXPECT_EQ(written(Design::RtlTimed, {LitClear, Missed, LitClear, LitClear, Missed}),
              (std::vector{0, 0, 2, 3, 4}));
    // Shadowed pixels do not touch the divider: 4612 + 7012 + 4541 = 16165 is 37 past.
    EXPECT_EQ(written(Design::RtlTimed, {LitClear, Shadowed, LitClear, Missed}),
              (std::vector{0, 0, 2, 3}));
}

} // namespace
} // namespace raymarch::engine::sphere
