// SPDX-License-Identifier: MIT
#include "drivers/led_patterns.hpp"

#include <gtest/gtest.h>

#include <string>

namespace raymarch::drivers
{
namespace
{

using std::chrono::milliseconds;

TEST(LedPatterns, TheHeartBeatsTwiceASecond)
{
    std::string second;
    for (int i = 0; i < 20; ++i)
        second += heartbeat(milliseconds{i * 50}) ? '#' : '.';
    EXPECT_EQ(second, "##..##..............");
    for (int i = 0; i < 1000; ++i)
        EXPECT_EQ(heartbeat(milliseconds{i}), heartbeat(milliseconds{i + 86'400'000})) << i;
}

std::string looks(Blinker& led, std::initializer_list<std::uint64_t> counts)
{
    std::string pattern;
    for (const std::uint64_t count : counts)
        pattern += led.sample(count) ? '#' : '.';
    return pattern;
}

TEST(LedPatterns, OneEventIsOneBlink)
{
    Blinker led;
    EXPECT_EQ(looks(led, {0, 0, 1, 1, 1, 1}), "..#...");
}

TEST(LedPatterns, AStreamOfEventsFlickers)
{
    Blinker led;
    EXPECT_EQ(looks(led, {1, 9, 30, 31, 32, 33}), "#.#.#.");
}

TEST(LedPatterns, AnEventDuringABlinkHasItsOwn)
{
    Blinker led;
    EXPECT_EQ(looks(led, {1, 2, 2, 2, 2}), "#.#..");
}

} // namespace
} // namespace raymarch::drivers
