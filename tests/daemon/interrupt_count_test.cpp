// SPDX-License-Identifier: MIT
#include "daemon/interrupt_count.hpp"

#include <gtest/gtest.h>

namespace raymarch::daemon
{
namespace
{

TEST(InterruptCount, WhatCameBeforeTheOpeningDoesNotCount)
{
    InterruptCount count;
    count.opened();
    count.take(1000);
    EXPECT_EQ(count.taken(), 1U);
    EXPECT_EQ(count.missed(), 0U);
    count.take(1001);
    EXPECT_EQ(count.taken(), 2U);
    EXPECT_EQ(count.missed(), 0U);
}

TEST(InterruptCount, AJumpShowsTheMissedOnes)
{
    InterruptCount count;
    count.take(10);
    count.take(14);
    EXPECT_EQ(count.taken(), 5U);
    EXPECT_EQ(count.missed(), 3U);
    count.take(14); // no interrupt came
    EXPECT_EQ(count.taken(), 5U);
    EXPECT_EQ(count.missed(), 3U);
}

TEST(InterruptCount, TheDevicesCountMayBeginAgainAtZero)
{
    InterruptCount count;
    count.take(0xFFFF'FFFF);
    count.take(1);
    EXPECT_EQ(count.taken(), 3U);
    EXPECT_EQ(count.missed(), 1U);
    count.opened();
    count.take(1); // the driver was loaded again
    EXPECT_EQ(count.taken(), 4U);
    EXPECT_EQ(count.missed(), 1U);
}

} // namespace
} // namespace raymarch::daemon
