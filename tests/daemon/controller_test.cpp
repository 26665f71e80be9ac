// SPDX-License-Identifier: MIT
#include "daemon/controller.hpp"

#include "protocol/accelerators.hpp"
#include "protocol/checksum.hpp"
#include "tests/fakes/service.hpp"

#include <gtest/gtest.h>

#include <string>
#include <string_view>

namespace raymarch::daemon
{
namespace
{

using test::Service;
namespace marcher = protocol::marcher;

/// Up to the sentence.
std::string head(const std::string& reply)
{
    return reply.substr(0, reply.find(" : "));
}

const std::string crooked = "SET FX=0.5\n"; // no longer of length 1

TEST(Controller, CountsUpdatesAndChangedWords)
{
    Service service;
    EXPECT_EQ(service.say("SET ZM=4\n"), "OK seq=1 changed=1\r\n");
    EXPECT_EQ(service.say("SET ZM=4\n"), "OK seq=2 changed=0\r\n");
    EXPECT_EQ(service.say("SET FY=0.001,R=0\n"),
              "OK seq=3 changed=2\r\n"); // FY stands in two words
    EXPECT_EQ(service.controller.applied(), 3U);
    EXPECT_EQ(service.board.calls, 3);
}

TEST(Controller, WithoutABoardNothingChanges)
{
    for (const Applied outcome : {Applied::Absent, Applied::Failed}) {
        Service service;
        service.board.outcome = outcome;
        const protocol::State before = service.controller.state();
        EXPECT_EQ(head(service.say("SET ZM=4\n")), "ERR HARDWARE");
        EXPECT_EQ(service.controller.state(), before);
        EXPECT_TRUE(service.controller.last_refused());
        EXPECT_TRUE(service.storage.changes.empty());
        EXPECT_EQ(service.say("GET ZM\n"), "OK ZM=3\r\n");
    }
}

TEST(Controller, ADeferredUpdateIsTaken)
{
    Service service;
    service.board.outcome = Applied::Deferred;
    EXPECT_EQ(service.say("SET ZM=4\n"), "OK seq=1 changed=1\r\n");
    EXPECT_EQ(service.say("GET ZM\n"), "OK ZM=4\r\n");
}

TEST(Controller, LockedRefusesWhateverWrites)
{
    Service service;
    service.controller.set_locked(true);
    for (const std::string line : {"SET ZM=4", "SET nonsense", "VIEW 0,0,3", "HUE 0", "RESET",
                                   "RANDOM", "PRESET cube", "LOAD", "FX=0", "ZM=4,"})
        EXPECT_EQ(head(service.say(line + "\n")), "ERR LOCKED") << line;
    for (const std::string line : {"GET", "REGS", "STATUS", "PRESET", "SAVE", "PING", "HELP",
                                   "VERSION", "ECHO off", "ACCELERATOR"})
        EXPECT_NE(service.say(line + "\n").find("OK"), std::string::npos) << line;
    EXPECT_EQ(service.board.calls, 0);
    EXPECT_NE(service.say("STATUS\n").find(" locked=on"), std::string::npos);
    service.controller.set_locked(false);
    EXPECT_EQ(service.say("SET ZM=4\n"), "OK seq=1 changed=1\r\n");
}

TEST(Controller, ABasisThatNoCameraHas)
{
    Service warning;
    EXPECT_EQ(warning.say(crooked), "OK seq=1 changed=1 warn=BASIS\r\n");

    Service off({.basis_check = BasisCheck::Off});
    EXPECT_EQ(off.say(crooked), "OK seq=1 changed=1\r\n");

    Service reject({.basis_check = BasisCheck::Reject});
    const protocol::State before = reject.controller.state();
    EXPECT_EQ(head(reject.say(crooked)), "ERR BASIS");
    EXPECT_EQ(reject.controller.state(), before);
    EXPECT_EQ(reject.board.calls, 0);
    EXPECT_EQ(reject.say("VIEW 30,20,3\n").substr(0, 8), "OK seq=1");
}

TEST(Controller, RepliesCanBeKeptBack)
{
    Service errors({.replies = Replies::Errors});
    EXPECT_EQ(errors.say("PING\nSET ZM=4\n"), "");
    EXPECT_EQ(head(errors.say("NOPE\n")), "ERR UNKNOWN_COMMAND col=1");
    Service none({.replies = Replies::None});
    EXPECT_EQ(none.say("PING\nNOPE\nSET ZM=4\n"), "");
    EXPECT_EQ(none.board.calls, 1); // it is applied all the same
}

TEST(Controller, APolicyCanChange)
{
    Service service;
    service.controller.set_policy({.require_checksum = true});
    EXPECT_EQ(head(service.say("PING\n")), "ERR CHECKSUM");
    EXPECT_EQ(service.say("PING*10\n"), "OK*04\r\n");
    EXPECT_EQ(service.say(" \n"), ""); // a blank line needs none
}

TEST(Controller, EveryLineOfAChecksummedReplyHasAMark)
{
    Service service;
    for (const std::string line : {"HELP*11", "NOPE*04", "GET*56"}) {
        std::string_view rest;
        const std::string reply = service.say(line + "\n");
        rest = reply;
        while (!rest.empty()) {
            const std::string_view each = rest.substr(0, rest.find("\r\n"));
            rest.remove_prefix(each.size() + 2);
            ASSERT_GT(each.size(), 3U);
            const std::uint8_t sum = protocol::xor_of(each.substr(0, each.size() - 3));
            const std::string mark = {'*', protocol::hex_digits[sum >> 4],
                                      protocol::hex_digits[sum & 0xF]};
            EXPECT_TRUE(each.ends_with(mark)) << each;
        }
    }
}

TEST(Controller, ErrorsOfUnmarkedLinesHaveNoMark)
{
    Service service;
    const std::string reply = service.say("FX=2\n");
    EXPECT_EQ(reply, "ERR RANGE col=4 key=FX : FX is a number -1 to 1\r\n");
}

TEST(Controller, SaveAndLoad)
{
    Service service;
    ASSERT_EQ(service.say("SET ZM=4\n"), "OK seq=1 changed=1\r\n");
    EXPECT_EQ(service.say("SAVE\n"), "OK\r\n");
    ASSERT_EQ(service.say("SET ZM=5,R=0\n"), "OK seq=2 changed=2\r\n");
    EXPECT_EQ(service.say("LOAD\n"), "OK seq=3 changed=2\r\n");
    EXPECT_EQ(service.say("GET ZM,R\n"), "OK ZM=4,R=0.999\r\n");
    service.storage.works = false;
    EXPECT_EQ(head(service.say("SAVE\n")), "ERR STORAGE");
    EXPECT_EQ(head(service.say("LOAD\n")), "ERR STORAGE");
    EXPECT_EQ(service.say("GET ZM\n"), "OK ZM=4\r\n");
}

TEST(Controller, TellsTheStorageOfChangesOnly)
{
    Service service;
    static_cast<void>(service.say("SET ZM=4\nSET ZM=4\nSET ZM=11\nGET\n"));
    ASSERT_EQ(service.storage.changes.size(), 1U);
    EXPECT_EQ(service.storage.changes[0], service.controller.state());
}

TEST(Controller, RestoringNeedsNoLine)
{
    Service service;
    protocol::State state = protocol::initial_state(protocol::marcher::description);
    state.codes[marcher::OBJ] = 2;
    EXPECT_TRUE(service.controller.restore(state));
    EXPECT_EQ(service.board.words, protocol::pack(protocol::marcher::description, state));
    EXPECT_EQ(service.say("GET OBJ\n"), "OK OBJ=infinite_cube\r\n");
    EXPECT_EQ(service.controller.applied(), 0U);

    service.board.outcome = Applied::Absent;
    state.codes[marcher::OBJ] = 3;
    EXPECT_FALSE(service.controller.restore(state));
    EXPECT_EQ(service.controller.state(), state); // kept for a board that comes later
    service.board.outcome = Applied::Written;
    service.controller.board_is_back(protocol::default_accelerator);
    EXPECT_EQ(service.board.words, protocol::pack(protocol::marcher::description, state));
}

TEST(Controller, StatusCountsRefusalsByCode)
{
    Service service;
    static_cast<void>(service.say("NOPE\nNOPE\nFX=2\nSET ZM=4\n"));
    EXPECT_EQ(service.say("STATUS\n"),
              "OK accelerator=marcher serial=up animate=0 locked=off applied=1 rejected=3 rejected.RANGE=1 "
              "rejected.UNKNOWN_COMMAND=2\r\n");
}

TEST(Controller, PresetsAreListedAndApplied)
{
    Service service;
    std::string names;
    for (const protocol::Preset& preset : marcher::presets)
        names += (names.empty() ? "" : ",") + std::string(preset.name);
    EXPECT_EQ(service.say("PRESET\n"), "OK presets=" + names + "\r\n");
    for (const protocol::Preset& preset : marcher::presets) {
        static_cast<void>(service.say("SET ZM=1,FX=1\n")); // must not shine through
        const std::string reply = service.say("preset " + std::string(preset.name) + "\n");
        EXPECT_TRUE(reply.starts_with("OK seq=")) << preset.name << ": " << reply;
        EXPECT_EQ(reply.find("warn"), std::string::npos) << preset.name;
    }
    EXPECT_EQ(head(service.say("PRESET nosuch\n")), "ERR ARGUMENT col=8");
}

TEST(Controller, HelpAnswersBeforeItsOk)
{
    Service service;
    const std::string all = service.say("HELP\n");
    EXPECT_TRUE(all.starts_with("# ")) << all;
    EXPECT_TRUE(all.ends_with("\r\nOK\r\n"));
    EXPECT_TRUE(service.say("help zm\n").starts_with("# ZM : "));
    EXPECT_EQ(head(service.say("HELP nothing\n")), "ERR ARGUMENT col=6");
}

TEST(Controller, RandomAppliesARealCamera)
{
    Service service({.basis_check = BasisCheck::Reject});
    for (int i = 0; i < 100; ++i)
        EXPECT_TRUE(service.say("RANDOM\n").starts_with("OK seq=")) << i;
    const protocol::State before = service.controller.state();
    EXPECT_TRUE(service.say("RANDOM Light\n").starts_with("OK seq="));
    EXPECT_EQ(service.controller.state().codes[marcher::FX], before.codes[marcher::FX]);
    EXPECT_EQ(head(service.say("RANDOM light camera\n")), "ERR ARGUMENT col=14");
}

TEST(Controller, VersionAndAcceleratorSayWhatTheyAre)
{
    Service service;
    EXPECT_EQ(service.say("VERSION\n"), "OK version=" RAYMARCH_VERSION " protocol=1\r\n");
    EXPECT_EQ(service.say("ACCELERATOR\n"), "OK accelerator=marcher\r\n");
}

} // namespace
} // namespace raymarch::daemon
