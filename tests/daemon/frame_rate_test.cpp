// SPDX-License-Identifier: MIT
#include "daemon/frame_rate.hpp"

#include <gtest/gtest.h>

namespace raymarch::daemon
{
namespace
{

using namespace std::chrono_literals;
const FrameRate::Clock::time_point start{};

TEST(FrameRate, NoTimeHasNoRate)
{
    FrameRate rate(5, start);
    EXPECT_EQ(rate.tenths_per_second(), std::nullopt);
    rate.sample(9, start);
    EXPECT_EQ(rate.tenths_per_second(), std::nullopt);
}

TEST(FrameRate, CountsFromTheOpening)
{
    FrameRate rate(1000, start);
    rate.sample(1015, start + 500ms);
    EXPECT_EQ(rate.tenths_per_second(), 300U);
}

TEST(FrameRate, CountsThatComeSeldomAreComparedWithTheOneBefore)
{
    FrameRate rate(0, start);
    rate.sample(100, start + 10s);
    EXPECT_EQ(rate.tenths_per_second(), 100U);
    rate.sample(300, start + 20s); // the mean of both would be 15
    EXPECT_EQ(rate.tenths_per_second(), 200U);
}

TEST(FrameRate, CountsThatComeOftenGiveThatOfTheLastSeconds)
{
    FrameRate rate(0, start);
    std::uint32_t frames = 0;
    auto now = start;
    for (int i = 0; i < 100; ++i) // 10 s at 10 frames a second
        rate.sample(++frames, now += 100ms);
    EXPECT_EQ(rate.tenths_per_second(), 100U);
    for (int i = 0; i < 60; ++i) // 3 s at 20 frames a second
        rate.sample(++frames, now += 50ms);
    EXPECT_EQ(rate.tenths_per_second(), 200U);
}

TEST(FrameRate, TwoLooksAtOnceGiveTheSame)
{
    FrameRate rate(0, start);
    rate.sample(100, start + 10s);
    rate.sample(100, start + 10s + 1ms);
    EXPECT_EQ(rate.tenths_per_second(), 99U); // 100 frames in 10.001 s, rounded down
}

TEST(FrameRate, AResetBeginsAnew)
{
    FrameRate rate(5000, start);
    rate.sample(3, start + 1s);
    EXPECT_EQ(rate.tenths_per_second(), std::nullopt);
    rate.sample(13, start + 1500ms);
    EXPECT_EQ(rate.tenths_per_second(), 200U);
}

} // namespace
} // namespace raymarch::daemon
