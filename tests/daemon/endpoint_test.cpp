// SPDX-License-Identifier: MIT
#include "daemon/endpoint.hpp"

#include "base/unique_fd.hpp"
#include "tests/fakes/service.hpp"

#include <gtest/gtest.h>

#include <sys/eventfd.h>

#include <algorithm>
#include <deque>
#include <memory>
#include <string>

namespace raymarch::daemon
{
namespace
{

/// A port with prepared input, which keeps its output.
class ScriptedPort final : public drivers::BytePort
{
  public:
    struct Script
    {
        std::deque<std::pair<drivers::ReadStatus, std::string>> reads; ///< the results of read()
        std::string written;
        std::size_t room = SIZE_MAX; ///< the bytes that still fit
    };
    explicit ScriptedPort(Script& script) : script_(script) {}

    [[nodiscard]] int fd() const noexcept override { return fd_.get(); }
    [[nodiscard]] drivers::ReadOutcome read(std::span<char> into) noexcept override
    {
        if (script_.reads.empty())
            return {drivers::ReadStatus::Empty, 0};
        const auto [status, bytes] = script_.reads.front();
        script_.reads.pop_front();
        std::copy(bytes.begin(), bytes.end(), into.begin());
        return {status, bytes.size()};
    }
    [[nodiscard]] std::size_t write(std::string_view bytes) noexcept override
    {
        bytes = bytes.substr(0, script_.room);
        script_.written += bytes;
        script_.room -= bytes.size();
        return bytes.size();
    }

  private:
    Script& script_;
    UniqueFd fd_{::eventfd(0, EFD_CLOEXEC)};
};

/// The serial port has the first rank, so resume() runs its turn at once.
class EndpointTest : public testing::Test
{
  protected:
    void says(const std::string& bytes)
    {
        port.reads.emplace_back(drivers::ReadStatus::Data, bytes);
    }
    void says(drivers::ReadStatus status) { port.reads.emplace_back(status, ""); }

    test::Service service;
    EventLoop loop = EventLoop::open().value();
    /// Each step of a test is one turn, also on a busy machine.
    Turns turns{loop, std::chrono::hours{1}};
    ScriptedPort::Script port;
    int gone = 0;
    Endpoint endpoint{loop,
                      turns,
                      Rank::First,
                      std::make_unique<ScriptedPort>(port),
                      service.controller,
                      [this](Endpoint&) { ++gone; }};
};

TEST_F(EndpointTest, AnswersWhatComes)
{
    says("PING\nGET");
    says(" ZM\r\n");
    endpoint.resume();
    EXPECT_EQ(port.written, "OK\r\nOK ZM=3\r\n");
}

TEST_F(EndpointTest, AnEchoGoesOutAtOnce)
{
    says("ECHO on\n");
    says("PI");
    endpoint.resume();
    EXPECT_EQ(port.written, "OK\r\nPI");
}

TEST_F(EndpointTest, WhatCameBeforeAHangUpIsDoneAndNotAnswered)
{
    says("SET ZM=4\nGET\n");
    says(drivers::ReadStatus::HungUp);
    service.storage.slow = true;
    says("SAVE\nSET ZM=5\n");
    endpoint.resume();
    EXPECT_EQ(endpoint.session().hang_ups(), 1U);
    port.written.clear();

    says(drivers::ReadStatus::HungUp); // while the disk works
    endpoint.resume();
    service.storage.finish();
    says("PING\n"); // the next host
    endpoint.resume();
    EXPECT_EQ(service.controller.applied(), 2U);
    EXPECT_EQ(endpoint.session().hang_ups(), 2U);
    EXPECT_EQ(endpoint.session().dropped_replies(), 2U);
    EXPECT_EQ(port.written, "OK\r\n");
}

TEST_F(EndpointTest, LinesThatCameBeforeTheEndAreDoneAndAnswered)
{
    says("GET ZM\nPING\nPI");
    says(drivers::ReadStatus::Gone);
    endpoint.resume();
    EXPECT_EQ(port.written, "OK ZM=3\r\nOK\r\n");
    EXPECT_EQ(gone, 1);
}

TEST_F(EndpointTest, ABusyHostIsReadOn)
{
    service.storage.slow = true;
    says("SAVE\n");
    endpoint.resume();
    EXPECT_TRUE(endpoint.busy());
    for (int i = 0; i < 3; ++i) {
        says("PING\n");
        endpoint.resume();
        EXPECT_TRUE(port.reads.empty());
    }
    EXPECT_EQ(port.written, "");
    service.storage.finish();
    endpoint.resume();
    EXPECT_EQ(port.written, "OK\r\nOK\r\nOK\r\nOK\r\n");
    EXPECT_FALSE(endpoint.busy());
}

/// A slow host gets every reply in order.
TEST_F(EndpointTest, AHostThatReadsSlowlyGetsAllOfIt)
{
    port.room = 0;
    std::string lines;
    for (int i = 0; i < 400; ++i)
        lines += "GET\n";
    says(lines);
    endpoint.resume();
    const auto replies = [this] { return std::ranges::count(port.written, '\n'); };
    Source reader = loop.add_timer([&] {
        if (replies() == 400)
            return loop.quit();
        port.room = 1000;
        endpoint.resume();
        reader->arm(std::chrono::milliseconds{1});
    });
    reader->arm(std::chrono::milliseconds{1});
    ASSERT_TRUE(loop.run());
    EXPECT_EQ(replies(), 400);
    EXPECT_EQ(endpoint.session().dropped_replies(), 0U);
}

} // namespace
} // namespace raymarch::daemon
