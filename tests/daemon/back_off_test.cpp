// SPDX-License-Identifier: MIT
#include "daemon/back_off.hpp"

#include <gtest/gtest.h>

namespace raymarch::daemon
{
namespace
{

TEST(BackOff, DoublesUpToHalfAMinute)
{
    BackOff back_off;
    for (const int expected : {250, 500, 1000, 2000, 4000, 8000, 16'000, 30'000, 30'000})
        EXPECT_EQ(back_off.next().count(), expected);
    back_off.reset();
    EXPECT_EQ(back_off.next().count(), 250);
}

/// The back-off starts again only if something stayed open for half a minute.
TEST(BackOff, OnlyWhatLastedBeginsAnew)
{
    using namespace std::chrono_literals;
    struct Row
    {
        BackOff::Clock::duration lasted;
        int next;
    };
    const auto day = 24h;
    for (const Row row : {Row{0s, 1000}, Row{29'999ms, 1000}, Row{30s, 250}, Row{day, 250}}) {
        BackOff back_off;
        EXPECT_EQ(back_off.next().count(), 250);
        EXPECT_EQ(back_off.next().count(), 500);
        const BackOff::Clock::time_point found{5min};
        back_off.opened(found);
        back_off.lost(found + row.lasted);
        EXPECT_EQ(back_off.next().count(), row.next);
    }
}

} // namespace
} // namespace raymarch::daemon
