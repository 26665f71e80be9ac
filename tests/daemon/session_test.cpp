// SPDX-License-Identifier: MIT
#include "daemon/session.hpp"

#include "tests/fakes/descriptions.hpp"
#include "tests/fakes/random.hpp"
#include "tests/fakes/service.hpp"

#include <gtest/gtest.h>

#include <algorithm>
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

/// A host that reads gets every reply, however many lines it has sent at once.
TEST(Session, ALineWaitsForRoomForItsReply)
{
    Service service;
    const std::string lines = repeated("GET\n", 1000) + repeated("HELP\n", 20);
    std::string_view bytes = lines;
    std::string replies;
    for (Step step = Step::Done; step != Step::Hungry;) {
        step = service.session.step(bytes, [] { return false; });
        ASSERT_NE(step, Step::Waits);
        if (step != Step::Full)
            continue;
        EXPECT_EQ(service.session.step(bytes, [] { return false; }), Step::Full);
        replies += service.session.output().pending();
        service.session.output().pop(service.session.output().pending().size());
    }
    replies += service.session.output().pending();
    EXPECT_EQ(service.session.dropped_replies(), 0U);
    std::string expected;
    Service other;
    for (std::string_view rest = lines; !rest.empty(); rest.remove_prefix(rest.find('\n') + 1))
        expected += other.say(rest.substr(0, rest.find('\n') + 1));
    EXPECT_EQ(replies, expected);
}

TEST(Session, TypedLinesWaitForRoomToo)
{
    Service service;
    static_cast<void>(service.say("ECHO on\n"));
    std::string_view bytes = "GET\rGET\r";
    while (service.session.output().room() >= protocol::longest_reply)
        ASSERT_TRUE(service.session.output().push("# filled\r\n"));
    EXPECT_EQ(service.session.step(bytes, [] { return false; }), Step::Full);
    EXPECT_EQ(bytes, "GET\rGET\r");
    service.session.output().clear();
    EXPECT_EQ(service.session.step(bytes, [] { return false; }), Step::Done);
    EXPECT_EQ(bytes, "GET\r");
}

TEST(Session, UnreadRepliesAreCountedWhenTheHostLeaves)
{
    Service service;
    service.session.receive("PING\nHELP\nGET R\n");
    service.session.output().pop(2); // the first reply was sent in part
    service.session.hang_up();
    EXPECT_EQ(service.session.dropped_replies(), 3U);
    service.session.receive("PING\nGET R\n");
    service.session.output().pop(4 + 4); // one and a part
    service.session.hang_up();
    EXPECT_EQ(service.session.dropped_replies(), 4U);
    service.session.receive("PING\nHELP\n");
    service.session.output().pop(4 + 10); // one, and the front of a reply of many lines
    service.session.drop_output();
    EXPECT_EQ(service.session.dropped_replies(), 5U);
    service.session.receive("PING\n");
    service.session.output().pop(4);
    service.session.hang_up();
    EXPECT_EQ(service.session.dropped_replies(), 5U);
}

TEST(Session, AnEchoIsNoReplyThatIsLost)
{
    Service service;
    static_cast<void>(service.say("ECHO on\n"));
    service.session.receive("ERRO");
    service.session.output().pop(2);
    service.session.hang_up();
    EXPECT_EQ(service.session.dropped_replies(), 0U);
    static_cast<void>(service.say("ECHO on\n"));
    service.session.receive("PING\rOK");
    service.session.drop_output();
    EXPECT_EQ(service.session.dropped_replies(), 1U);
}

/// However much has gone through the queue before.
TEST(Session, LostRepliesAreCountedInAnyPlaceOfTheQueue)
{
    Service service;
    auto random = test::seeded_random();
    std::uint64_t lost = 0;
    for (int i = 0; i < 2000; ++i) {
        const int lines = test::pick(random, 1, 60);
        std::string replies;
        for (int j = 0; j < lines; ++j) {
            service.session.receive(test::pick(random, 0, 1) == 0 ? "PING\n" : "GET\n");
            replies = service.session.output().pending();
        }
        const auto sent = test::pick(random, std::size_t{0}, replies.size());
        service.session.output().pop(sent);
        const auto whole = std::ranges::count(replies.substr(0, sent), '\n');
        lost += static_cast<std::uint64_t>(lines - whole);
        service.session.drop_output();
        ASSERT_EQ(service.session.dropped_replies(), lost);
    }
}

TEST(Session, AnEchoOfItsRepliesIsNotAnswered)
{
    Service service;
    const std::string replies = service.say("PING\nNOPE\nHELP\nGET\nPING*10\nSET ZM=11\n");
    EXPECT_EQ(service.say(replies), "");
    EXPECT_EQ(service.say("OK " + std::string(3000, 'x') + "\n"), "");
    EXPECT_EQ(service.say("  OK\r\n# x\rERR\x80\n"), "");
    const std::string status = service.say("STATUS\n");
    EXPECT_NE(status.find(" rejected=2 "), std::string::npos) << status;
    EXPECT_EQ(status.find(" echoed=0"), std::string::npos) << status;
}

/// Lines of other hosts go on while a disk works; the host's own next line waits.
class SlowDisk : public testing::Test
{
  protected:
    SlowDisk() { service.storage.slow = true; }

    /// Steps until nothing more can be done; what is left of the bytes.
    Step go(std::string_view& bytes)
    {
        Step step = Step::Done;
        while (step == Step::Done)
            step = service.session.step(bytes, [] { return false; });
        return step;
    }
    std::string take_replies()
    {
        std::string replies(service.session.output().pending());
        service.session.output().pop(replies.size());
        return replies;
    }
    Service service;
    Session other{service.controller};
};

TEST_F(SlowDisk, SaveIsAnsweredWhenTheDiskHasIt)
{
    std::string_view bytes = "SAVE*01\nGET ZM\n";
    EXPECT_EQ(go(bytes), Step::Waits);
    EXPECT_EQ(bytes, "GET ZM\n");
    other.receive("SET ZM=4\n");
    EXPECT_EQ(other.output().pending(), "OK seq=1 changed=1\r\n");
    EXPECT_EQ(take_replies(), "");
    service.storage.finish();
    EXPECT_EQ(go(bytes), Step::Hungry);
    EXPECT_EQ(take_replies(), "OK*04\r\nOK ZM=4\r\n");
    EXPECT_EQ(service.storage.saved,
              protocol::initial_state(protocol::default_accelerator)); // as it was then
}

TEST_F(SlowDisk, ASaveThatFailsIsAnErrorThen)
{
    std::string_view bytes = "SAVE\n";
    EXPECT_EQ(go(bytes), Step::Waits);
    service.storage.works = false;
    service.storage.finish();
    EXPECT_EQ(go(bytes), Step::Hungry);
    EXPECT_TRUE(take_replies().starts_with("ERR STORAGE"));
}

TEST_F(SlowDisk, LoadAppliesWhatComes)
{
    service.storage.saved = service.controller.state();
    std::string_view bytes = "LOAD\n";
    EXPECT_EQ(go(bytes), Step::Waits);
    other.receive("SET ZM=4\n");
    service.storage.finish();
    EXPECT_EQ(go(bytes), Step::Hungry);
    EXPECT_EQ(take_replies(), "OK seq=2 changed=1\r\n");
    EXPECT_EQ(service.controller.state(), *service.storage.saved);
}

TEST_F(SlowDisk, LoadIsRefusedWhereTheAcceleratorIsAnotherOneByThen)
{
    service.board.emulated = true;
    service.storage.saved = service.controller.state();
    std::string_view bytes = "LOAD\n";
    EXPECT_EQ(go(bytes), Step::Waits);
    other.receive("ACCELERATOR fractal\n");
    service.storage.finish();
    EXPECT_EQ(go(bytes), Step::Hungry);
    EXPECT_TRUE(take_replies().starts_with("ERR BUSY"));
}

TEST_F(SlowDisk, LoadIsRefusedWhereTheBoardIsLockedByThen)
{
    service.storage.saved = service.controller.state();
    std::string_view bytes = "LOAD\n";
    EXPECT_EQ(go(bytes), Step::Waits);
    service.controller.set_locked(true);
    service.storage.finish();
    EXPECT_EQ(go(bytes), Step::Hungry);
    EXPECT_TRUE(take_replies().starts_with("ERR LOCKED"));
}

TEST_F(SlowDisk, TheNextHostDoesNotGetAReplyToTheLastOnes)
{
    std::string_view bytes = "SAVE\n";
    EXPECT_EQ(go(bytes), Step::Waits);
    service.session.hang_up();
    service.storage.finish();
    bytes = "PING\n";
    EXPECT_EQ(go(bytes), Step::Hungry);
    EXPECT_EQ(take_replies(), "OK\r\n");
}

/// A turn that is over after each step of a movement.
class LongMovement : public testing::TestWithParam<const protocol::Accelerator*>
{
  protected:
    const protocol::Accelerator& accelerator = *GetParam();
    Service service{{}, accelerator};
    Service reference{{}, accelerator};
    Session other{service.controller};

    Step one_step(std::string_view& bytes)
    {
        return service.session.step(bytes, [] { return true; });
    }
    std::string finish(std::string_view& bytes)
    {
        while (one_step(bytes) == Step::Done) {
        }
        std::string replies(service.session.output().pending());
        service.session.output().pop(replies.size());
        return replies;
    }
};
INSTANTIATE_TEST_SUITE_P(Accelerators, LongMovement, testing::ValuesIn(protocol::accelerators),
                         test::accelerator_name);

TEST_P(LongMovement, InPiecesIsTheSameAsAtOnce)
{
    for (const std::string line :
         {"WALK forward 50\n", "TURN left 30\n", "WALK left 9\n", "WALK forward\n"}) {
        std::string_view bytes = line;
        const int calls = service.board.calls;
        ASSERT_EQ(finish(bytes), reference.say(line)) << line;
        ASSERT_EQ(service.controller.state(), reference.controller.state()) << line;
        EXPECT_EQ(service.board.words, reference.board.words) << line;
        EXPECT_EQ(service.board.calls, calls + 1) << line; // the registers are written once
    }
}

TEST_P(LongMovement, OthersAreServedMeanwhile)
{
    std::string_view bytes = "WALK forward 50\nPING\n";
    for (int i = 0; i < 5; ++i)
        ASSERT_EQ(one_step(bytes), Step::Done);
    other.receive("PING\n");
    EXPECT_EQ(other.output().pending(), "OK\r\n");
    EXPECT_EQ(service.controller.state(), protocol::initial_state(accelerator));
    EXPECT_EQ(bytes, "PING\n");
    EXPECT_TRUE(finish(bytes).ends_with("\r\nOK\r\n"));
}

/// As if the other's line had come first: the steps that nobody has seen yet are made again.
TEST_P(LongMovement, WhatOthersChangeMeanwhileCounts)
{
    std::string_view bytes = "WALK forward 20\n";
    for (int i = 0; i < 5; ++i)
        ASSERT_EQ(one_step(bytes), Step::Done);
    other.receive("RANDOM\n");
    reference.board.words = service.board.words;
    ASSERT_TRUE(reference.controller.restore(service.controller.state()));
    static_cast<void>(finish(bytes));
    static_cast<void>(reference.say("WALK forward 20\n"));
    EXPECT_EQ(service.controller.state(), reference.controller.state());
    EXPECT_EQ(service.board.words, reference.board.words);
}

/// It comes to an end however often others write.
TEST_P(LongMovement, EndsThoughOthersWriteAllTheTime)
{
    std::string_view bytes = "WALK forward 50\n";
    ASSERT_EQ(one_step(bytes), Step::Done);
    int pieces = 1;
    while (service.session.output().pending().empty() && pieces < 1000) {
        other.receive("RANDOM\n");
        ASSERT_EQ(one_step(bytes), Step::Done);
        ++pieces;
    }
    EXPECT_LE(pieces, 52);
    EXPECT_TRUE(service.session.output().pending().starts_with("OK seq="));
}

TEST_P(LongMovement, ASwitchEndsIt)
{
    service.board.emulated = true;
    std::string_view bytes = "WALK forward 50\nPING\n";
    ASSERT_EQ(one_step(bytes), Step::Done);
    const protocol::Accelerator& next =
        *protocol::accelerators[(accelerator.kind + 1U) % protocol::accelerators.size()];
    other.receive("ACCELERATOR " + std::string(next.name) + "\n");
    const std::string replies = finish(bytes);
    EXPECT_TRUE(replies.starts_with("ERR BUSY")) << replies;
    EXPECT_TRUE(replies.ends_with("\r\nOK\r\n")) << replies;
    EXPECT_EQ(service.controller.state(), protocol::initial_state(next));
}

TEST_P(LongMovement, ALockEndsItAndNothingHasChanged)
{
    std::string_view bytes = "WALK forward 50\n";
    ASSERT_EQ(one_step(bytes), Step::Done);
    service.controller.set_locked(true);
    EXPECT_TRUE(finish(bytes).starts_with("ERR LOCKED"));
    EXPECT_EQ(service.controller.state(), protocol::initial_state(accelerator));
    service.controller.set_locked(false);
    EXPECT_EQ(service.say("WALK forward 3\n"), reference.say("WALK forward 3\n"));
    EXPECT_EQ(service.controller.state(), reference.controller.state());
}

/// While one host's movement is under way, another host's moves too.
TEST_P(LongMovement, TwoHostsMayMoveAtOnce)
{
    std::string_view bytes = "WALK forward 50\n";
    ASSERT_EQ(one_step(bytes), Step::Done);
    other.receive("WALK forward 3\n");
    static_cast<void>(reference.say("WALK forward 3\n"));
    EXPECT_EQ(service.controller.state(), reference.controller.state());
    static_cast<void>(finish(bytes));
    EXPECT_TRUE(service.controller.applied() == 2);
}

TEST_P(LongMovement, ABoardThatFailsAtItsEndChangesNothing)
{
    std::string_view bytes = "WALK forward 50\n";
    ASSERT_EQ(one_step(bytes), Step::Done);
    service.board.outcome = Applied::Failed;
    EXPECT_TRUE(finish(bytes).starts_with("ERR HARDWARE"));
    EXPECT_EQ(service.controller.state(), protocol::initial_state(accelerator));
}

TEST_P(LongMovement, AHostThatLeavesEndsIt)
{
    std::string_view bytes = "WALK forward 50\n";
    ASSERT_EQ(one_step(bytes), Step::Done);
    service.session.hang_up();
    bytes = "PING\n";
    EXPECT_EQ(finish(bytes), "OK\r\n");
    EXPECT_EQ(service.controller.state(), protocol::initial_state(accelerator));
    EXPECT_EQ(service.say("WALK forward 3\n"), reference.say("WALK forward 3\n"));
    EXPECT_EQ(service.controller.state(), reference.controller.state());
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

/// The LF of CR LF belongs to the line before it, on which echo was turned on or off.
TEST(Session, TheEndingOfTheLineThatTurnsEchoIsOne)
{
    Service service;
    EXPECT_EQ(service.say("ECHO on\r\n"), "OK\r\n");
    EXPECT_EQ(service.say("PING\r\n"), "PING\r\nOK\r\n");
    EXPECT_EQ(service.say("ECHO off\r"), "ECHO off\r\nOK\r\n");
    EXPECT_EQ(service.say("\nPING\r\n"), "OK\r\n");
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
