// SPDX-License-Identifier: MIT
#include "daemon/controller.hpp"

#include "protocol/accelerators.hpp"
#include "protocol/assignments.hpp"
#include "protocol/checksum.hpp"
#include "protocol/commands.hpp"
#include "protocol/views.hpp"
#include "tests/fakes/descriptions.hpp"
#include "tests/fakes/service.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace raymarch::daemon
{
namespace
{

using test::head;
using test::Service;
namespace marcher = protocol::marcher;

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

TEST(Controller, RefusedIsSaidOfTheLastLineThatWasToWrite)
{
    Service service;
    const auto refused_after = [&](const std::string& line) {
        static_cast<void>(service.say(line + "\n"));
        return service.controller.last_refused();
    };
    EXPECT_FALSE(refused_after("SET ZM=4"));
    for (const std::string bad :
         {"FX=2", "SET ZM=11", "SET", "PRESET nosuch", "garbage\x01", "NOPE"}) {
        EXPECT_TRUE(refused_after(bad)) << bad;
        EXPECT_TRUE(refused_after("STATUS")) << "a line that reads changes nothing";
        EXPECT_FALSE(refused_after("SET ZM=4")) << bad;
        EXPECT_FALSE(refused_after("HELP nothing")) << "nor does one that is refused";
    }
    service.controller.set_locked(true);
    EXPECT_TRUE(refused_after("SET ZM=4"));
}

TEST(Controller, ButtonsWorkWhileHostsAreLockedOut)
{
    Service service;
    service.controller.set_locked(true);
    service.controller.to_next_scene();
    EXPECT_EQ(service.say("GET OBJ\n"), "OK OBJ=cube\r\n");
    service.controller.orbit(Side::Right);
    EXPECT_GT(service.controller.state().codes[marcher::FX], 0);
    service.controller.to_defaults();
    EXPECT_EQ(service.controller.state(), protocol::initial_state(marcher::description));
    EXPECT_EQ(service.storage.changes.size(), 3U);
    EXPECT_EQ(service.controller.applied(), 0U);
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
    EXPECT_EQ(service.say("STATUS\n"), "OK accelerator=marcher serial=up animate=0 locked=off "
                                       "applied=1 rejected=3 echoed=0 rejected.RANGE=1 "
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

class EveryController : public test::EveryAccelerator
{
  protected:
    Service service{{}, accelerator};
};
INSTANTIATE_TEST_SUITE_P(Accelerators, EveryController, testing::ValuesIn(protocol::accelerators),
                         test::accelerator_name);

TEST_P(EveryController, StartsWithTheDefaults)
{
    const protocol::State initial = protocol::initial_state(accelerator);
    EXPECT_EQ(service.controller.state(), initial);
    EXPECT_EQ(service.say("ACCELERATOR\n"),
              "OK accelerator=" + std::string(accelerator.name) + "\r\n");
    EXPECT_TRUE(service.say("STATUS\n")
                    .starts_with("OK accelerator=" + std::string(accelerator.name) + " "));
    EXPECT_EQ(service.say(test::default_frame(accelerator) + "\n"), "OK seq=1 changed=0\r\n");
    EXPECT_EQ(service.controller.state(), initial);
    EXPECT_EQ(service.board.words, protocol::pack(accelerator, initial));
}

TEST_P(EveryController, WhatGetSaysIsTakenBySet)
{
    auto random = test::seeded_random();
    const protocol::State state = test::random_state(accelerator, random);
    ASSERT_TRUE(service.controller.restore(state));
    const std::string all = service.say("GET\n");
    ASSERT_TRUE(all.starts_with("OK ") && all.ends_with("\r\n"));
    std::string_view rest = std::string_view(all).substr(3, all.size() - 5);
    ASSERT_TRUE(service.controller.restore(protocol::initial_state(accelerator)));
    // Tables make more pairs than one line holds.
    while (!rest.empty()) {
        const std::string_view pair = rest.substr(0, rest.find(','));
        rest.remove_prefix(std::min(pair.size() + 1, rest.size()));
        EXPECT_TRUE(service.say("SET " + std::string(pair) + "\n").starts_with("OK seq=")) << pair;
        const std::string key(pair.substr(0, pair.find('=')));
        EXPECT_EQ(service.say("GET " + key + "\n"), "OK " + std::string(pair) + "\r\n");
    }
    EXPECT_EQ(service.controller.state(), state);
    EXPECT_EQ(service.board.words, protocol::pack(accelerator, state));
}

TEST_P(EveryController, ButtonsDoSomethingAndUndoIt)
{
    const protocol::State initial = protocol::initial_state(accelerator);
    for (const Side side : {Side::Left, Side::Right}) {
        service.controller.orbit(side);
        EXPECT_FALSE(service.controller.state() == initial);
        service.controller.to_defaults();
        EXPECT_EQ(service.controller.state(), initial);
    }
    service.controller.to_next_scene();
    service.controller.to_next_scene();
    EXPECT_FALSE(service.controller.state() == initial);
    EXPECT_EQ(service.board.words, protocol::pack(accelerator, service.controller.state()));
}

TEST_P(EveryController, WhatTheBoardDoesNotTakeAButtonDoesNotDo)
{
    service.controller.to_next_scene();
    const protocol::State before = service.controller.state();
    for (const Applied refused : {Applied::Absent, Applied::Failed}) {
        service.board.outcome = refused;
        service.controller.to_next_scene();
        service.controller.to_defaults();
        service.controller.orbit(Side::Left);
        EXPECT_EQ(service.controller.state(), before);
    }
    service.board.outcome = Applied::Written;
    service.controller.to_next_scene(); // the very next, none was passed over
    std::optional<std::size_t> shown = 0;
    EXPECT_EQ(service.controller.state(), protocol::next_scene(accelerator, before, shown));
}

/// What a person may ask, each line of it with a mark: the longest that replies become.
TEST_P(EveryController, NoReplyIsCutOff)
{
    auto random = test::seeded_random();
    ASSERT_TRUE(service.controller.restore(test::random_state(accelerator, random)));
    std::vector<std::string> lines = {"HELP", "GET", "REGS", "STATUS", "PRESET", "QQQ=0"};
    for (const protocol::Parameter& parameter : table) {
        if (!parameter.is_tail())
            lines.push_back("HELP " + std::string(parameter.key));
    }
    lines.push_back(test::default_pair(table[0])); // and the rest is missing
    for (const std::string& line : lines) {
        const std::uint8_t sum = protocol::xor_of(line);
        const std::string marked =
            line + '*' + protocol::hex_digits[sum >> 4] + protocol::hex_digits[sum & 0xF];
        const std::string reply = service.say(marked + "\n");
        ASSERT_GT(reply.size(), 5U) << line;
        const std::size_t last = reply.find_last_of('\n', reply.size() - 2) + 1; // npos + 1 is 0
        const std::string_view end = std::string_view(reply).substr(last);
        EXPECT_TRUE(end.starts_with("OK") || end.starts_with("ERR ")) << line << ": " << end;
        EXPECT_TRUE(end.ends_with("\r\n")) << line;
        EXPECT_EQ(end[end.size() - 5], '*') << line << ": " << end;
    }
}

/// In GET's own spelling, so with as many digits as a value can need.
TEST_P(EveryController, AFrameFitsALine)
{
    auto random = test::seeded_random();
    for (int i = 0; i < 100; ++i) {
        const protocol::State state = test::random_state(accelerator, random);
        protocol::ReplyWriter frame;
        for (std::size_t p = 0; p < table.size(); ++p) {
            if (!accelerator.frame[p])
                continue;
            frame << (p == 0 ? "" : ",");
            protocol::write_assignment(frame, accelerator, state, p);
        }
        ASSERT_TRUE(service.say(std::string(frame.text()) + "\n").starts_with("OK seq="))
            << frame.text();
    }
}

TEST_P(EveryController, PresetsAreListedAndApplied)
{
    std::string names;
    for (const protocol::Preset& preset : accelerator.presets)
        names += (names.empty() ? "" : ",") + std::string(preset.name);
    EXPECT_EQ(service.say("PRESET\n"), "OK presets=" + names + "\r\n");
    auto random = test::seeded_random();
    for (const protocol::Preset& preset : accelerator.presets) {
        ASSERT_TRUE(service.controller.restore(test::random_state(accelerator, random)));
        const std::string reply = service.say("PRESET " + std::string(preset.name) + "\n");
        EXPECT_TRUE(reply.starts_with("OK seq=")) << preset.name << ": " << reply;
        protocol::State expected = protocol::initial_state(accelerator);
        protocol::ParameterSet given;
        EXPECT_FALSE(
            protocol::read_assignments(accelerator, {.bytes = preset.settings}, expected, given));
        EXPECT_EQ(service.controller.state(), expected) << preset.name;
    }
}

TEST_P(EveryController, RandomAndResetByGroup)
{
    for (const protocol::Parameter& parameter : table) {
        const std::string group(parameter.group);
        EXPECT_TRUE(service.say("RANDOM " + group + "\n").starts_with("OK seq=")) << group;
        EXPECT_TRUE(service.say("RESET " + group + "\n").starts_with("OK seq=")) << group;
        EXPECT_EQ(service.controller.state(), protocol::initial_state(accelerator)) << group;
    }
    EXPECT_TRUE(service.say("RANDOM\n").starts_with("OK seq="));
    EXPECT_FALSE(service.controller.state() == protocol::initial_state(accelerator));
}

TEST_P(EveryController, SwitchesToEachOtherAndBack)
{
    service.board.emulated = true;
    auto random = test::seeded_random();
    for (const protocol::Accelerator* other : protocol::accelerators) {
        if (other == &accelerator)
            continue;
        protocol::State had = test::random_state(*other, random);
        service.storage.lasts[other] = had;
        const std::string name(other->name);
        EXPECT_EQ(service.say("ACCELERATOR " + name + "\n"), "OK accelerator=" + name + "\r\n");
        EXPECT_EQ(service.board.used, other);
        EXPECT_EQ(&service.controller.accelerator(), other);
        EXPECT_EQ(service.controller.state(), had) << "as it was left";
        EXPECT_EQ(service.board.words, protocol::pack(*other, had)) << name;
        const std::string key(other->parameters[0].key);
        EXPECT_TRUE(service.say("GET " + key + "\n").starts_with("OK " + key + "=")) << name;
        EXPECT_TRUE(service.say(test::default_frame(*other) + "\n").starts_with("OK seq=")) << name;

        service.storage.lasts.clear();
        EXPECT_TRUE(service.say("accelerator " + std::string(accelerator.name) + "\n")
                        .starts_with("OK accelerator="));
        EXPECT_EQ(service.controller.state(), protocol::initial_state(accelerator))
            << "the defaults, where nothing is known";
    }
}

TEST_P(EveryController, ABoardThatComesBackAsAnother)
{
    auto random = test::seeded_random();
    const protocol::State before = test::random_state(accelerator, random);
    ASSERT_TRUE(service.controller.restore(before));
    service.board.words = {};
    service.controller.board_is_back(accelerator);
    EXPECT_EQ(service.board.words, protocol::pack(accelerator, before)) << "the present words";
    for (const protocol::Accelerator* other : protocol::accelerators) {
        const protocol::State had = test::random_state(*other, random);
        service.storage.lasts[other] = had;
        const bool another = other != &service.controller.accelerator();
        service.controller.board_is_back(*other);
        EXPECT_EQ(&service.controller.accelerator(), other);
        const protocol::State& expected = another ? had : before;
        if (another || other == &accelerator) {
            EXPECT_EQ(service.controller.state(), expected) << other->name;
            EXPECT_EQ(service.board.words, protocol::pack(*other, expected)) << other->name;
        }
    }
    EXPECT_EQ(service.board.used, nullptr) << "the board says what it is; nobody asks it to change";
}

TEST(Accelerator, OnlyAnEmulatedBlockIsSwitched)
{
    Service service;
    const std::string other(protocol::accelerators[1]->name);
    EXPECT_EQ(head(service.say("ACCELERATOR " + other + "\n")), "ERR ARGUMENT col=13");
    EXPECT_EQ(&service.controller.accelerator(), &protocol::default_accelerator);
    EXPECT_EQ(service.board.calls, 0);
    // The one that is active already is no switch.
    EXPECT_EQ(service.say("ACCELERATOR marcher\n"), "OK accelerator=marcher\r\n");
    EXPECT_EQ(service.board.calls, 0);
}

TEST(Accelerator, AnUnknownOneIsRefused)
{
    Service service;
    service.board.emulated = true;
    for (const std::string name : {"nosuch", "fractals", "fractal sphere", "1"})
        EXPECT_EQ(head(service.say("ACCELERATOR " + name + "\n")), "ERR ARGUMENT col=13") << name;
    EXPECT_EQ(service.board.used, nullptr);
}

TEST(Accelerator, LockedStaysAsItIs)
{
    Service service;
    service.board.emulated = true;
    service.controller.set_locked(true);
    for (const std::string name : {"fractal", "marcher", "nosuch"})
        EXPECT_EQ(head(service.say("ACCELERATOR " + name + "\n")), "ERR LOCKED") << name;
    EXPECT_EQ(service.say("ACCELERATOR\n"), "OK accelerator=marcher\r\n");
    EXPECT_EQ(service.board.used, nullptr);
}

TEST(Accelerator, ABoardThatTakesNoWordsIsReported)
{
    Service service;
    service.board.emulated = true;
    service.board.outcome = Applied::Failed;
    EXPECT_EQ(head(service.say("ACCELERATOR fractal\n")), "ERR HARDWARE");
    service.board.outcome = Applied::Written;
    EXPECT_EQ(service.say("ACCELERATOR\n"), "OK accelerator=fractal\r\n"); // it is that one now
    EXPECT_EQ(service.say("SET SCENE=maze\n"), "OK seq=1 changed=1\r\n");
}

} // namespace
} // namespace raymarch::daemon
