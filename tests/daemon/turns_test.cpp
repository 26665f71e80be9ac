// SPDX-License-Identifier: MIT
#include "daemon/turns.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <ctime>
#include <list>
#include <memory>
#include <optional>

namespace raymarch::daemon
{
namespace
{

void use_processor(std::chrono::microseconds time)
{
    const auto now = [] {
        timespec used = {};
        ::clock_gettime(CLOCK_THREAD_CPUTIME_ID, &used);
        return std::chrono::seconds(used.tv_sec) + std::chrono::nanoseconds(used.tv_nsec);
    };
    const auto end = now() + time;
    while (now() < end) {
    }
}

/// Some hosts always have work; a silent host sends something after many turns.
class TurnsTest : public testing::Test
{
  protected:
    void add_busy(Rank rank)
    {
        busy.emplace_back(turns, rank, [this](const TurnIsOver&) {
            use_processor(std::chrono::microseconds{200});
            after_turn();
            return true;
        });
        busy.back().ready();
    }
    void after_turn()
    {
        ++count;
        if (count == 200)
            silent.ready();
        if (count == 300)
            loop.quit();
    }

    EventLoop loop = EventLoop::open().value();
    Turns turns{loop};
    std::list<Turn> busy;
    int count = 0;
    int served_at = 0;
    Turn silent{turns, Rank::Equal, [this](const TurnIsOver&) {
                    served_at = count;
                    return false;
                }};
};

TEST_F(TurnsTest, WhoWasSilentWaitsForATurnOrTwo)
{
    for (int i = 0; i < 15; ++i)
        add_busy(Rank::Equal);
    ASSERT_TRUE(loop.run());
    EXPECT_GE(served_at, 200);
    EXPECT_LE(served_at, 202);
}

/// The serial port gets every second turn, which is much more than an equal share.
TEST_F(TurnsTest, AHostGetsItsTurnBesideTheSerialPortToo)
{
    add_busy(Rank::First);
    add_busy(Rank::Equal);
    add_busy(Rank::Equal);
    ASSERT_TRUE(loop.run());
    EXPECT_GE(served_at, 200);
    EXPECT_LE(served_at, 203);
}

TEST_F(TurnsTest, TheSerialPortWaitsForOneTurn)
{
    for (int i = 0; i < 5; ++i)
        add_busy(Rank::Equal);
    int serial_at = 0;
    Turn serial(turns, Rank::First, [&](const TurnIsOver&) {
        serial_at = count;
        return false;
    });
    Source call = loop.add_timer([&] {
        serial.ready();
        const int asked_at = count;
        EXPECT_LE(serial_at - asked_at, 1);
    });
    call->arm(std::chrono::milliseconds{1});
    ASSERT_TRUE(loop.run());
    EXPECT_GT(serial_at, 0);
}

TEST_F(TurnsTest, AHostMayEndInItsTurn)
{
    auto gone = std::make_unique<std::optional<Turn>>();
    gone->emplace(turns, Rank::Equal, [&](const TurnIsOver&) {
        gone->reset();
        loop.quit();
        return false;
    });
    (*gone)->ready();
    ASSERT_TRUE(loop.run());
    EXPECT_FALSE(gone->has_value());
}

} // namespace
} // namespace raymarch::daemon
