// SPDX-License-Identifier: MIT
/// @file
/// The test sets the clock. The tests of retries use a real loop.
#include "daemon/reopener.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <functional>
#include <set>
#include <string>
#include <utility>

namespace raymarch::daemon
{
namespace
{

using namespace std::chrono_literals;

Error unplugged(const std::string& message = "it is unplugged")
{
    return plain_error(ErrorKind::Unavailable, message);
}

class ReopenerTest : public testing::Test
{
  protected:
    /// Returns the log lines of `action`.
    template <typename Action>
    std::string log_of(Action action)
    {
        testing::internal::CaptureStderr();
        action();
        return testing::internal::GetCapturedStderr();
    }

    EventLoop loop = *EventLoop::open();
    BackOff::Clock::time_point now{5min};
    int looks = 0;
    std::function<void()> look = [this] { ++looks; };
    Reopener reopener{loop, "no lamp", [this] { look(); }, "it is waited for",
                      [this] { return now; }};
};

TEST_F(ReopenerTest, AProblemIsLoggedOnceUntilItIsAnother)
{
    const auto missing = [&](const std::string& why) {
        return log_of([&] { reopener.missing(unplugged(why)); });
    };
    EXPECT_NE(missing("it is unplugged").find("no lamp: it is unplugged; it is waited for\n"),
              std::string::npos);
    EXPECT_EQ(missing("it is unplugged"), "");
    EXPECT_NE(missing("it is broken").find("no lamp: it is broken;"), std::string::npos);
    EXPECT_NE(missing("it is unplugged"), "") << "it was another one meanwhile";
    EXPECT_EQ(log_of([&] { reopener.found(); }), "");
    EXPECT_NE(missing("it is unplugged"), "") << "it was there meanwhile";
}

TEST_F(ReopenerTest, OfSeveralProblemsTheNewOnesAreLogged)
{
    const auto tell = [&](std::set<std::string> problems) {
        return log_of([&] { reopener.log_new(std::move(problems)); });
    };
    EXPECT_NE(tell({"a", "b"}).find("no lamp: a; b; it will be tried again\n"), std::string::npos);
    EXPECT_EQ(tell({"a", "b"}), "");
    EXPECT_NE(tell({"b", "c"}).find("no lamp: c; it"), std::string::npos);
    EXPECT_EQ(tell({}), "");
    EXPECT_NE(tell({"c"}), "");
    EXPECT_EQ(log_of([&] { reopener.log_new({"d"}, log::Level::Debug, "never mind"); }), "");
}

TEST_F(ReopenerTest, ItWaitsLongerEachTimeWhileItIsMissing)
{
    const std::string log = log_of([&] {
        for (const auto wait : {250ms, 500ms, 1000ms, 2000ms}) {
            reopener.missing(unplugged());
            EXPECT_EQ(reopener.wait(), wait);
        }
    });
    EXPECT_NE(log, "");
}

/// The back-off also grows if something is found and lost again and again.
TEST_F(ReopenerTest, OnlyWhatStayedForHalfAMinuteIsLookedForSoon)
{
    reopener.lost();
    EXPECT_EQ(reopener.wait(), 250ms);
    for (const auto wait : {500ms, 1000ms}) {
        reopener.found();
        now += 29s;
        reopener.lost();
        EXPECT_EQ(reopener.wait(), wait);
    }
    reopener.found();
    now += 30s;
    reopener.lost();
    EXPECT_EQ(reopener.wait(), 250ms);
}

TEST_F(ReopenerTest, SomeOfItIsFoundAndLostWithoutAWord)
{
    EXPECT_NE(log_of([&] { reopener.missing(unplugged()); }), "");
    reopener.some_found();
    EXPECT_EQ(log_of([&] { reopener.missing(unplugged()); }), "") << "the rest is missing still";
    EXPECT_EQ(reopener.wait(), 500ms);
    now += 30s;
    reopener.some_lost();
    reopener.retry_later();
    EXPECT_EQ(reopener.wait(), 250ms);
}

/// The loop retries after the delay, and stops after found().
TEST_F(ReopenerTest, TheLoopLooksUntilItIsFound)
{
    const auto begin = std::chrono::steady_clock::now();
    look = [this] {
        if (++looks < 3)
            return reopener.missing(unplugged());
        reopener.found();
        loop.quit();
    };
    const std::string log = log_of([&] {
        reopener.retry_now();
        ASSERT_TRUE(loop.run());
    });
    EXPECT_EQ(looks, 3);
    EXPECT_GE(std::chrono::steady_clock::now() - begin, 750ms) << "at once, then 250 and 500 ms";
    EXPECT_EQ(log.find("no lamp"), log.rfind("no lamp")) << "once: " << log;
}

TEST_F(ReopenerTest, AReasonToLookEndsALongWait)
{
    for (int i = 0; i < 12; ++i)
        reopener.retry_later();
    EXPECT_EQ(reopener.wait(), 30s);
    look = [this] {
        reopener.retry_later();
        EXPECT_EQ(reopener.wait(), 250ms);
        loop.quit();
    };
    reopener.start_again();
    ASSERT_TRUE(loop.run());
}

} // namespace
} // namespace raymarch::daemon
