// SPDX-License-Identifier: MIT
#include "drivers/ports.hpp"
#include "tests/fakes/memory_pin.hpp"

#include <gtest/gtest.h>

#include <poll.h>

namespace raymarch::test
{
namespace
{

bool edge_waits(const drivers::Pin& pin)
{
    pollfd waiting = {.fd = pin.edge_fd(), .events = POLLIN, .revents = 0};
    return ::poll(&waiting, 1, 0) == 1;
}

TEST(Pin, TheFakeShowsALevelAndReportsEdges)
{
    MemoryPin button;
    drivers::Pin& pin = button;
    EXPECT_EQ(*pin.read(), false);
    EXPECT_FALSE(edge_waits(pin));
    button.drive(false);
    EXPECT_FALSE(edge_waits(pin)) << "no change is no edge";
    button.drive(true);
    EXPECT_EQ(*pin.read(), true);
    EXPECT_TRUE(edge_waits(pin));
}

TEST(Pin, AnOutputHoldsWhatIsWritten)
{
    MemoryPin led;
    EXPECT_TRUE(led.write(true));
    EXPECT_TRUE(*led.read());
}

} // namespace
} // namespace raymarch::test
