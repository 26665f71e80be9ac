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

} // namespace
} // namespace raymarch::daemon
