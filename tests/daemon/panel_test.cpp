// SPDX-License-Identifier: MIT
/// @file
/// Tests the panel in a real event loop with lines in memory. A test waits for events and not for a
/// time. That something does not happen is checked after a later event.
#include "daemon/panel.hpp"

#include "base/log.hpp"
#include "protocol/accelerators.hpp"
#include "tests/fakes/memory_bank.hpp"
#include "tests/fakes/service.hpp"
#include "tests/fakes/temporary_folder.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace raymarch::daemon
{
namespace
{

using std::chrono::milliseconds;
namespace marcher = protocol::marcher;

class PanelTest : public testing::Test
{
  protected:
    PanelTest()
    {
        config.gpio.debounce = milliseconds{1};
        config.gpio.orbit_rate = config.gpio.turn_rate = 60;
    }

    void start()
    {
        panel.emplace(
            config.gpio, loop, service.controller, service.board,
            [this](const drivers::LineSpec& spec, drivers::LineUse use) {
                return bank.open(spec, use);
            },
            devices);
        panel->start();
    }

    /// One action of a test and its result.
    struct Step
    {
        std::function<void()> happens;
        std::function<bool()> comes;
    };
    /// Runs the steps in the loop. Returns false if a step does not end in a long time.
    [[nodiscard]] bool play(const std::vector<Step>& steps)
    {
        const auto deadline = std::chrono::steady_clock::now() + std::chrono::seconds{30};
        std::size_t at = 0;
        bool begun = false;
        Source clock;
        clock = loop.add_timer([&] {
            if (!std::exchange(begun, true))
                steps[at].happens();
            if (steps[at].comes()) {
                ++at;
                begun = false;
            }
            if (at == steps.size() || std::chrono::steady_clock::now() > deadline)
                loop.quit();
            else
                clock->arm(milliseconds{1});
        });
        clock->arm({});
        EXPECT_TRUE(loop.run());
        EXPECT_EQ(at, steps.size()) << "the step that did not come to its end";
        return at == steps.size();
    }

    /// A press or a release that is stable before the next edge.
    void drive(const std::string& line, bool on) { bank[line].drive(on, now += milliseconds{100}); }
    [[nodiscard]] bool lit(const std::string& line) { return *bank[line].read(); }
    [[nodiscard]] protocol::State state() const { return service.controller.state(); }
    [[nodiscard]] std::string status()
    {
        protocol::ReplyWriter reply;
        reply.begin(false);
        protocol::StatusValues status;
        panel->write_status(status);
        status.write(reply);
        return std::string(reply.text());
    }
    [[nodiscard]] bool refused(const char* line) { return service.say(line).starts_with("ERR"); }

    milliseconds now{0};
    test::MemoryBank bank;
    test::Service service;
    Config config = default_config();
    test::TemporaryFolder folder;
    std::string devices = folder / "";
    EventLoop loop = *EventLoop::open();
    std::optional<Panel> panel;
};

const std::function<void()> nothing = [] {};

TEST_F(PanelTest, OpensEveryLineForItsUse)
{
    start();
    EXPECT_EQ(bank.open_count(), actions().size());
    EXPECT_EQ(bank.use("btn0"), drivers::LineUse::Input);
    EXPECT_EQ(bank.use("sw1"), drivers::LineUse::Input);
    EXPECT_EQ(bank.use("led4_g"), drivers::LineUse::Output);
    EXPECT_EQ(status(), " gpio=up");
}

TEST_F(PanelTest, AnActionWithoutALineIsSwitchedOff)
{
    ASSERT_TRUE(set_line(config, "reset", "none"));
    ASSERT_TRUE(set_line(config, "heartbeat", "elsewhere"));
    start();
    EXPECT_FALSE(bank.is_open("btn0"));
    EXPECT_FALSE(bank.is_open("led0"));
    EXPECT_TRUE(bank.is_open("elsewhere"));
    EXPECT_EQ(status(), " gpio=up");
}

TEST_F(PanelTest, WithoutGpioNoLineIsTouched)
{
    config.gpio.used = false;
    start();
    EXPECT_EQ(bank.attempts, 0);
    EXPECT_EQ(status(), " gpio=none");
}

TEST_F(PanelTest, PressesCountOnceEach)
{
    start();
    ASSERT_TRUE(play({
        {[&] { drive("btn1", true); }, [&] { return state().codes[marcher::OBJ] == 1; }},
        {[&] {
             drive("btn1", false);
             drive("btn1", true);
         },
         [&] { return state().codes[marcher::OBJ] == 2; }},
        {[&] { drive("btn0", true); },
         [&] { return state() == protocol::initial_state(protocol::default_accelerator); }},
    }));
    EXPECT_EQ(service.board.calls, 3);
    EXPECT_EQ(service.controller.applied(), 0U) << "counts what hosts sent";
}

TEST_F(PanelTest, AButtonThatIsHeldWhenItIsFoundIsNotPressed)
{
    bank["btn1"].drive(true);
    static_cast<void>(bank["btn1"].take_edge()); // before the panel listens
    start();
    ASSERT_TRUE(play({
        {[&] {
             drive("btn1", false);
             drive("btn1", true);
         },
         [&] { return service.board.calls == 1; }},
    }));
    EXPECT_EQ(state().codes[marcher::OBJ], 1);
}

TEST_F(PanelTest, TheCameraOrbitsWhileAButtonIsHeld)
{
    start();
    ASSERT_TRUE(play({
        {[&] { drive("btn3", true); }, [&] { return service.board.calls >= 5; }},
        {[&] {
             drive("btn3", false);
             drive("btn2", true);
         }, // were both held, neither would win
         [&] { return state().codes[marcher::FX] < 0; }},
    }));
}

TEST_F(PanelTest, ASwitchLocksAndUnlocksHosts)
{
    bank["sw0"].drive(true);
    static_cast<void>(bank["sw0"].take_edge());
    start();
    EXPECT_TRUE(refused("SET ZM=4\n")) << "it was on at the start";
    EXPECT_TRUE(service.say("GET ZM\n").starts_with("OK"));
    ASSERT_TRUE(play({
        {[&] { drive("btn1", true); }, [&] { return state().codes[marcher::OBJ] == 1; }},
        {[&] { drive("sw0", false); }, [&] { return !refused("SET ZM=4\n"); }},
        {[&] { drive("sw0", true); }, [&] { return refused("SET ZM=5\n"); }},
    }));
}

TEST_F(PanelTest, ASwitchTurnsTheCameraByItself)
{
    bank["sw1"].drive(true);
    static_cast<void>(bank["sw1"].take_edge());
    start();
    ASSERT_TRUE(play({{nothing, [&] { return service.board.calls >= 3; }}}));
    EXPECT_GT(state().codes[marcher::FX], 0);
}

TEST_F(PanelTest, InputsWithoutEdgesAreSampled)
{
    bank.unheard = {"btn1", "sw0"};
    start();
    ASSERT_TRUE(play({
        {[&] { drive("btn1", true); }, [&] { return state().codes[marcher::OBJ] == 1; }},
        {[&] { drive("sw0", true); }, [&] { return refused("SET ZM=4\n"); }},
    }));
}

TEST_F(PanelTest, LedsShowFramesAndHardware)
{
    start();
    ASSERT_TRUE(play({
        {nothing, [&] { return lit("led0") && lit("led3") && !lit("led2"); }},
        {nothing, [&] { return !lit("led0"); }}, // it beats
        {[&] { static_cast<void>(service.say("SET ZM=4\n")); }, [&] { return lit("led1"); }},
        {nothing, [&] { return !lit("led1"); }},
        {[&] { static_cast<void>(service.say("SET ZM=11\n")); }, [&] { return lit("led2"); }},
        {[&] { static_cast<void>(service.say("SET ZM=5\n")); }, [&] { return !lit("led2"); }},
        {[&] { service.board.present = {.fault = true, .running = false}; },
         [&] { return lit("led2") && !lit("led3"); }},
        {[&] { service.board.present = {.fault = false, .running = true}; },
         [&] { return !lit("led2") && lit("led3"); }},
    }));
}

TEST_F(PanelTest, ThreeLedsShowTheColour)
{
    bank["led5_g"].drive(true); // another program has lit it
    start();
    const auto shows = [&](bool red, bool green, bool blue) {
        return lit("led4_r") == red && lit("led4_g") == green && lit("led4_b") == blue;
    };
    ASSERT_TRUE(play({
        {nothing, [&] { return shows(true, true, true); }},
        {[&] { static_cast<void>(service.say("SET R=0.51,G=0.49,B=0\n")); },
         [&] { return shows(true, false, false); }},
        {[&] { static_cast<void>(service.say("HUE 0.5\n")); },
         [&] { return shows(false, true, true); }},
    }));
    EXPECT_FALSE(lit("led5_r") || lit("led5_g") || lit("led5_b"));
}

TEST_F(PanelTest, LedsGoDarkWithTheService)
{
    start();
    ASSERT_TRUE(play({{nothing, [&] { return lit("led3") && lit("led4_r"); }}}));
    panel.reset();
    for (const std::string name : {"led0", "led3", "led4_r", "led4_g", "led4_b"})
        EXPECT_FALSE(lit(name)) << name;
    EXPECT_EQ(bank.open_count(), 0U);
}

TEST_F(PanelTest, MissingLinesAreLookedForAndTheOthersWork)
{
    bank.missing = {"btn0", "led3"};
    start();
    EXPECT_EQ(status(), " gpio=partial");
    ASSERT_TRUE(play({
        {[&] { drive("btn1", true); }, [&] { return state().codes[marcher::OBJ] == 1; }},
        {[&] { bank.missing.clear(); }, [&] { return lit("led3"); }},
        {[&] { drive("btn0", true); }, [&] { return state().codes[marcher::OBJ] == 0; }},
    }));
    EXPECT_EQ(status(), " gpio=up");
}

TEST_F(PanelTest, WithoutAnyLineTheServiceGoesOn)
{
    for (const Action& action : actions())
        bank.missing.insert(std::string(action.line));
    testing::internal::CaptureStderr();
    start();
    EXPECT_EQ(status(), " gpio=down");
    EXPECT_FALSE(refused("SET ZM=4\n"));
    const std::size_t all = actions().size();
    ASSERT_TRUE(play({{nothing, [&] { return bank.attempts >= static_cast<int>(3 * all); }},
                      {[&] { bank.missing.clear(); }, [&] { return bank.open_count() == all; }}}));
    EXPECT_EQ(status(), " gpio=up");
    const std::string log = testing::internal::GetCapturedStderr();
    const std::size_t reported = log.find("no GPIO line is named led5_r");
    ASSERT_NE(reported, std::string::npos) << log;
    EXPECT_EQ(log.find("no GPIO line", log.find('\n', reported)), std::string::npos) << "once";
}

/// The lines are tried twice at the start, because a chip may appear in between, and then only when
/// a chip appears.
TEST_F(PanelTest, WithoutAnyChipNothingIsLookedForUntilOneComes)
{
    ASSERT_TRUE(set_line(config, "reset", "/dev/gpiochip0:3"));
    bank.no_chip = true;
    const int all = static_cast<int>(actions().size());
    log::set_level(log::Level::Info);
    testing::internal::CaptureStderr();
    start();
    EXPECT_EQ(status(), " gpio=down");
    bool over = false;
    const Source later =
        loop.add_timer([&] { over = true; }); // the back-off would have retried twice by then
    ASSERT_TRUE(play({
        {nothing, [&] { return bank.attempts == 2 * all; }},
        {[&] {
             later->arm(milliseconds{900});
             test::write_text(folder / "ttyUSB7", "");
         },
         [&] { return over; }},
        {[&] {
             EXPECT_EQ(bank.attempts, 2 * all);
             test::write_text(folder / "gpiochip0", ""); // its driver may not be ready
         },
         [&] { return bank.attempts == 3 * all; }},
        {[&] {
             bank.no_chip = false;
             std::filesystem::rename(folder / "ttyUSB7", folder / "gpiochip1");
         },
         [&] { return bank.open_count() == actions().size(); }},
    }));
    EXPECT_EQ(status(), " gpio=up");
    const std::string log = testing::internal::GetCapturedStderr();
    log::set_level(log::Level::Notice);
    EXPECT_NE(log.find("there is no GPIO chip; a chip that appears later is used"),
              std::string::npos)
        << log;
    EXPECT_EQ(log.find("GPIO chip", log.find('\n')), std::string::npos) << "once: " << log;
}

/// The chip has no permissions yet when it appears, so the lines are tried again with the back-off.
TEST_F(PanelTest, AChipThatCannotBeOpenedYetIsTriedAgain)
{
    bank.no_chip = true;
    start();
    const int all = static_cast<int>(actions().size());
    ASSERT_TRUE(play({
        {nothing, [&] { return bank.attempts == 2 * all; }},
        {[&] {
             bank.no_chip = false;
             for (const Action& action : actions())
                 bank.missing.insert(std::string(action.line));
             test::write_text(folder / "gpiochip0", "");
         },
         [&] { return bank.attempts >= 4 * all; }},
        {[&] { bank.missing.clear(); }, [&] { return status() == " gpio=up"; }},
    }));
}

TEST_F(PanelTest, WhereNobodyTellsOfChipsTheyAreLookedFor)
{
    devices = folder / "no such folder";
    bank.no_chip = true;
    start();
    const int all = static_cast<int>(actions().size());
    ASSERT_TRUE(play({
        {nothing, [&] { return bank.attempts >= 3 * all; }},
        {[&] { bank.no_chip = false; }, [&] { return status() == " gpio=up"; }},
    }));
}

TEST_F(PanelTest, ALineThatGoesAwayIsFoundAgain)
{
    start();
    ASSERT_TRUE(play({
        {[&] { drive("btn3", true); }, [&] { return service.board.calls >= 2; }},
        {[&] {
             bank.missing = bank.broken = {"btn3", "led0"};
             drive("btn3", false);
         },
         [&] { return !bank.is_open("btn3") && !bank.is_open("led0"); }},
        {[&] {
             EXPECT_EQ(status(), " gpio=partial");
             bank.missing = bank.broken = {};
         },
         [&] { return bank.is_open("btn3") && lit("led0"); }},
        {[&] {
             service.board.calls = 0;
             drive("btn3", true);
         },
         [&] { return service.board.calls >= 2; }},
    }));
    EXPECT_EQ(status(), " gpio=up");
}

} // namespace
} // namespace raymarch::daemon
