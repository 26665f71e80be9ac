// SPDX-License-Identifier: MIT
#include "daemon/session.hpp"

#include "tests/fakes/descriptions.hpp"
#include "tests/fakes/service.hpp"

#include <gtest/gtest.h>

#include <string>

namespace raymarch::daemon
{
namespace
{

using test::Service;

std::string repeated(std::string_view text, int count)
{
    std::string all;
    for (int i = 0; i < count; ++i)
        all += text;
    return all;
}

TEST(Session, AnswersLineByLineInOrder)
{
    Service service;
    EXPECT_EQ(service.say("PI"), "");
    EXPECT_EQ(service.say("NG\nGET R"), "OK\r\n");
    EXPECT_EQ(service.say("\n"), "OK R=0.999\r\n");
}

TEST(Session, RepliesThatAreNotReadAreDroppedWholeAndCounted)
{
    Service service;
    service.session.receive(repeated("PING\n", 5000)); // 4 bytes a reply; 16384 fit
    EXPECT_EQ(service.session.output().pending(), repeated("OK\r\n", 4096));
    EXPECT_EQ(service.session.dropped_replies(), 904U);
    service.session.output().pop(3);
    service.session.receive("PING\n"); // 3 bytes of room: still none for a whole reply
    EXPECT_EQ(service.session.dropped_replies(), 905U);
    service.session.output().pop(1);
    service.session.receive("PING\n");
    EXPECT_EQ(service.session.dropped_replies(), 905U);
    EXPECT_EQ(service.session.output().pending(), repeated("OK\r\n", 4096));
}

TEST(Session, WhatIsDroppedIsAppliedAllTheSame)
{
    Service service;
    service.session.receive(repeated("PING\n", 5000));
    service.session.receive("SET ZM=4\n");
    EXPECT_EQ(service.board.calls, 1);
}

TEST(Session, AHangUpForgetsHalfALineAndUnreadReplies)
{
    Service service;
    service.session.receive("PING\nSET ZM=4");
    service.session.hang_up();
    EXPECT_EQ(service.say("\nPING\n"), "OK\r\n");
    EXPECT_EQ(service.board.calls, 0);
}

TEST(Session, AHangUpEndsDroppingAnOverlongLine)
{
    Service service;
    service.session.receive(std::string(2000, 'x'));
    service.session.hang_up();
    EXPECT_EQ(service.say("PING\n"), "OK\r\n");
}

TEST(Session, EchoBeginsWithTheNextLine)
{
    Service service;
    EXPECT_EQ(service.say("ECHO on\nPIX\bNG\r\n"), "OK\r\nPIX\b \bNG\r\nOK\r\n");
    EXPECT_EQ(service.say("ECHO off\r\nPING\n"), "ECHO off\r\nOK\r\nOK\r\n");
}

TEST(Session, AnOverlongTypedLineIsTooLong)
{
    Service service;
    static_cast<void>(service.say("ECHO on\n"));
    const std::string replies = service.say(std::string(1025, 'x') + "\r");
    EXPECT_NE(replies.find("\r\nERR TOO_LONG"), std::string::npos);
    const std::string longest = service.say(std::string(1024, 'x') + "\r");
    EXPECT_NE(longest.find("\r\nERR UNKNOWN_COMMAND"), std::string::npos);
}

TEST(Session, AHangUpTurnsEchoOff)
{
    Service service;
    static_cast<void>(service.say("ECHO on\nPI"));
    service.session.hang_up();
    EXPECT_EQ(service.say("PING\n"), "OK\r\n");
}

TEST(Session, TwoHostsShareOneState)
{
    Service service;
    Session other(service.controller);
    other.receive("SET ZM=4\nECHO on\n");
    EXPECT_EQ(service.say("GET ZM\n"), "OK ZM=4\r\n"); // and has no echo
}

class EverySession : public test::EveryAccelerator
{
  protected:
    Service service{{}, accelerator};
};
INSTANTIATE_TEST_SUITE_P(Accelerators, EverySession, testing::ValuesIn(protocol::accelerators),
                         test::accelerator_name);

TEST_P(EverySession, AnyChunkingIsTheSameToIt)
{
    const std::string lines = test::default_frame(accelerator) + "\nGET\nREGS\r\nHELP\nPRESET\n";
    const std::string whole = service.say(lines);
    for (const std::size_t size : {1, 7, 64}) {
        Service other({}, accelerator);
        std::string replies;
        for (std::size_t at = 0; at < lines.size(); at += size)
            replies += other.say(lines.substr(at, size));
        EXPECT_EQ(replies, whole) << size;
    }
}

/// The longest replies of all fit what is kept for a host that reads them one by one.
TEST_P(EverySession, NoReplyIsDroppedForItsLength)
{
    for (const std::string line : {"HELP\n", "GET\n", "REGS\n", "Q=1\n"})
        EXPECT_FALSE(service.say(line).empty()) << line;
    EXPECT_EQ(service.session.dropped_replies(), 0U);
}

TEST_P(EverySession, HostsSeeTheSameAccelerator)
{
    service.board.emulated = true;
    Session other(service.controller);
    const protocol::Accelerator& next =
        *protocol::accelerators[(accelerator.kind + 1U) % protocol::accelerators.size()];
    other.receive("ACCELERATOR " + std::string(next.name) + "\n");
    EXPECT_EQ(service.say("ACCELERATOR\n"), "OK accelerator=" + std::string(next.name) + "\r\n");
    EXPECT_EQ(service.say(test::default_frame(next) + "\n"), "OK seq=1 changed=0\r\n");
}

} // namespace
} // namespace raymarch::daemon
