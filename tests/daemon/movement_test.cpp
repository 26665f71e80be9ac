// SPDX-License-Identifier: MIT
#include "daemon/movement.hpp"

#include "motion/directions.hpp"
#include "motion/movers.hpp"
#include "protocol/commands.hpp"
#include "tests/fakes/descriptions.hpp"
#include "tests/fakes/service.hpp"

#include <gtest/gtest.h>

#include <array>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace raymarch::daemon
{
namespace
{

using motion::Input;
using test::head;
using test::Service;

TEST(Movement, EveryDirectionOfTheTableIsAnInputOfItsOwn)
{
    std::vector<Input> inputs(motion::walk_inputs.begin(), motion::walk_inputs.end());
    inputs.insert(inputs.end(), motion::turn_inputs.begin(), motion::turn_inputs.end());
    EXPECT_EQ(std::set<Input>(inputs.begin(), inputs.end()).size(), inputs.size());
}

struct NamedInput
{
    std::string_view name;
    std::optional<Input> walk;
    std::optional<Input> turn;
};

constexpr std::array named_inputs = {
    NamedInput{"forward", Input::Forward, std::nullopt},
    NamedInput{"back", Input::Back, std::nullopt},
    NamedInput{"left", Input::StrafeLeft, Input::TurnLeft},
    NamedInput{"RIGHT", Input::StrafeRight, Input::TurnRight},
    NamedInput{"up", Input::Up, Input::TurnUp},
    NamedInput{"down", Input::Down, Input::TurnDown},
    NamedInput{"roll_left", std::nullopt, Input::RollLeft},
    NamedInput{"Roll_Right", std::nullopt, Input::RollRight},
    NamedInput{"wide", std::nullopt, Input::Widen},
    NamedInput{"narrow", std::nullopt, Input::Narrow},
};

TEST(Movement, WordsOfWalkAndTurn)
{
    for (const NamedInput& row : named_inputs) {
        EXPECT_EQ(motion::walk_input(row.name), row.walk) << row.name;
        EXPECT_EQ(motion::turn_input(row.name), row.turn) << row.name;
    }
}

struct FaultRow
{
    std::string_view words;
    std::size_t column;
};

constexpr std::array walk_faults = {
    FaultRow{"sideways", 1},       FaultRow{"forwards", 1},    FaultRow{"3", 1},
    FaultRow{"roll_left", 1},      FaultRow{"forward 0", 9},   FaultRow{"forward 1001", 9},
    FaultRow{"forward -1", 9},     FaultRow{"forward +1", 9},  FaultRow{"forward 1.5", 9},
    FaultRow{"forward   two", 11}, FaultRow{"forward 3 4", 9}, FaultRow{"forward 4294967297", 9},
    FaultRow{"forward,3", 1},
};

constexpr std::array turn_faults = {
    FaultRow{"forward", 1},   FaultRow{"roll", 1},   FaultRow{"left 0", 6},
    FaultRow{"left 1001", 6}, FaultRow{"wide x", 6}, FaultRow{"narrow 99999999999", 8},
};

constexpr std::array animate_faults = {
    FaultRow{"yes", 1},    FaultRow{"20", 1},     FaultRow{"on 0", 4},  FaultRow{"on 61", 4},
    FaultRow{"on -1", 4},  FaultRow{"on x", 4},   FaultRow{"off 1", 5}, FaultRow{"off 0", 5},
    FaultRow{"on 1 2", 4}, FaultRow{"on 1.5", 4},
};

TEST(Movement, FaultsHaveTheirColumns)
{
    Service service;
    const auto expect_faults = [&](std::string_view command, auto& rows) {
        for (const FaultRow& row : rows) {
            const std::string line = std::string(command) + " " + std::string(row.words);
            EXPECT_EQ(head(service.say(line + "\n")),
                      "ERR ARGUMENT col=" + std::to_string(command.size() + 1 + row.column))
                << line;
        }
        // Without a word: behind the command.
        EXPECT_EQ(head(service.say(std::string(command) + "\n")),
                  "ERR ARGUMENT col=" + std::to_string(command.size() + 1));
    };
    expect_faults("WALK", walk_faults);
    expect_faults("TURN", turn_faults);
    expect_faults("ANIMATE", animate_faults);
    EXPECT_EQ(service.board.calls, 0);
}

TEST(Movement, RatesOfAnimate)
{
    Service service;
    unsigned rate = 99;
    service.controller.on_animate([&](unsigned asked) { rate = asked; });
    const auto asked = [&](const std::string& words) {
        EXPECT_EQ(service.say("ANIMATE " + words + "\n"), "OK\r\n") << words;
        return rate;
    };
    EXPECT_EQ(asked("on"), 20U);
    EXPECT_EQ(asked("ON 1"), 1U);
    EXPECT_EQ(asked("on 60"), 60U);
    EXPECT_EQ(asked("off"), 0U);
    EXPECT_EQ(asked("on 0059"), 59U);
    EXPECT_EQ(asked("Off"), 0U);
}

class EveryMovement : public test::EveryAccelerator
{
  protected:
    Service service{{.basis_check = BasisCheck::Reject}, accelerator};
};
INSTANTIATE_TEST_SUITE_P(Accelerators, EveryMovement, testing::ValuesIn(protocol::accelerators),
                         test::accelerator_name);

TEST_P(EveryMovement, EachDirectionIsTaken)
{
    for (const std::string_view name : protocol::walk_directions)
        EXPECT_TRUE(service.say("WALK " + std::string(name) + " 3\n").starts_with("OK seq="))
            << name;
    for (const std::string_view name : protocol::turn_directions)
        EXPECT_TRUE(service.say("TURN " + std::string(name) + " 3\n").starts_with("OK seq="))
            << name;
    EXPECT_EQ(service.board.words, protocol::pack(accelerator, service.controller.state()));
    for (std::size_t i = 0; i < table.size(); ++i) { // so that GET's text can be sent back
        EXPECT_GE(service.controller.state().codes[i], table[i].min_scaled) << table[i].key;
        EXPECT_LE(service.controller.state().codes[i], table[i].max_scaled) << table[i].key;
    }
}

TEST_P(EveryMovement, SomethingMoves)
{
    std::set<std::string> replies;
    for (const std::string line : {"WALK forward", "WALK back", "WALK left", "TURN left"})
        replies.insert(service.say(line + "\n"));
    EXPECT_FALSE(service.controller.state() == protocol::initial_state(accelerator));
}

TEST_P(EveryMovement, ManyStepsAreThatManyTimesOne)
{
    Service one_by_one({}, accelerator);
    for (int i = 0; i < 7; ++i)
        static_cast<void>(one_by_one.say("TURN left\n"));
    static_cast<void>(service.say("TURN left 7\n"));
    EXPECT_EQ(service.controller.state(), one_by_one.controller.state());
    EXPECT_EQ(service.controller.applied(), 1U);
    EXPECT_EQ(one_by_one.controller.applied(), 7U);
}

TEST_P(EveryMovement, LockedStandsStill)
{
    service.controller.set_locked(true);
    for (const std::string line : {"WALK forward", "TURN left 3", "ANIMATE on", "WALK nowhere"})
        EXPECT_EQ(head(service.say(line + "\n")), "ERR LOCKED") << line;
    service.controller.animate();
    EXPECT_EQ(service.board.calls, 0);
    EXPECT_EQ(service.controller.state(), protocol::initial_state(accelerator));
}

TEST_P(EveryMovement, TheAnimationIsPacedAndApplied)
{
    std::vector<unsigned> paces;
    service.controller.on_animate([&](unsigned rate) { paces.push_back(rate); });
    EXPECT_EQ(service.say("ANIMATE on 30\nANIMATE on\n"), "OK\r\nOK\r\n");
    EXPECT_NE(service.say("STATUS\n").find(" animate=20 "), std::string::npos);
    for (int i = 0; i < 5; ++i)
        service.controller.animate();
    EXPECT_EQ(service.say("ANIMATE off\n"), "OK\r\n");
    EXPECT_EQ(paces, (std::vector<unsigned>{30, 20, 0}));
    EXPECT_NE(service.say("STATUS\n").find(" animate=0 "), std::string::npos);
    // Steps that changed the state reached the board and the storage; the others disturb nobody.
    EXPECT_EQ(static_cast<std::size_t>(service.board.calls), service.storage.changes.size());
    if (!service.storage.changes.empty()) {
        EXPECT_EQ(service.storage.changes.back(), service.controller.state());
    }
    EXPECT_EQ(service.controller.applied(), 0U); // counts what hosts sent
}

TEST_P(EveryMovement, AStepThatTheBoardDoesNotTakeIsNotMade)
{
    const protocol::State before = service.controller.state();
    for (const Applied refused : {Applied::Absent, Applied::Failed}) {
        service.board.outcome = refused;
        service.controller.animate();
        EXPECT_EQ(service.controller.state(), before);
        EXPECT_GT(std::exchange(service.board.calls, 0), 0); // it was tried
    }
    EXPECT_TRUE(service.storage.changes.empty());
    service.board.outcome = Applied::Written;
    service.controller.animate();
    EXPECT_NE(service.controller.state(), before);
}

TEST_P(EveryMovement, GoesOnAfterASwitchAndBack)
{
    service.board.emulated = true;
    static_cast<void>(service.say("TURN left 3\n"));
    const protocol::State left = service.controller.state();
    service.storage.lasts[&accelerator] = left;
    for (const protocol::Accelerator* other : protocol::accelerators) {
        if (other == &accelerator)
            continue;
        static_cast<void>(service.say("ACCELERATOR " + std::string(other->name) + "\n"));
        EXPECT_TRUE(service.say("TURN right 2\n").starts_with("OK seq=")) << other->name;
        static_cast<void>(service.say("ACCELERATOR " + std::string(accelerator.name) + "\n"));
        EXPECT_EQ(service.controller.state(), left) << other->name;
        service.storage.lasts.erase(other);
    }
    EXPECT_TRUE(service.say("TURN left\n").starts_with("OK seq="));
}

} // namespace
} // namespace raymarch::daemon
