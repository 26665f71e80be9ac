// SPDX-License-Identifier: MIT
#include "protocol/typed_request.hpp"

#include "protocol/accelerators.hpp"
#include "tests/fakes/descriptions.hpp"
#include "tests/protocol/accelerator.hpp"

#include <gtest/gtest.h>

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <variant>

namespace raymarch::protocol
{
namespace
{

/// A line, and what it is for an accelerator whose values are the defaults.
class Parsed
{
  public:
    explicit Parsed(std::string_view line, const Accelerator& accelerator = protocol::accelerator)
        : present_(initial_state(accelerator))
        , result_(present_)
        , request_(parse({.bytes = line}, {accelerator, present_, result_}, false))
    {}

    [[nodiscard]] const TypedRequest& request() const { return request_; }
    [[nodiscard]] const Fault* fault() const { return std::get_if<Fault>(&request_.what); }
    /// Null if the line is no such command.
    template <CommandName name>
    [[nodiscard]] const Command<name>* command() const
    {
        const auto* const any = std::get_if<AnyCommand<commands>>(&request_.what);
        return any == nullptr ? nullptr : std::get_if<Command<name>>(any);
    }

  private:
    State present_;
    State result_;
    TypedRequest request_;
};

TEST(TypedRequest, LinesWithoutAReply)
{
    for (const std::string_view line : {"", "  ", " \t", "OK seq=1", "# help", "ERR RANGE"}) {
        const Parsed parsed(line);
        ASSERT_TRUE(std::holds_alternative<Silence>(parsed.request().what)) << line;
        EXPECT_EQ(std::get<Silence>(parsed.request().what) == Silence::Blank,
                  line.find_first_not_of(" \t") == std::string_view::npos)
            << line;
    }
}

TEST(TypedRequest, AFrameGivesItsState)
{
    const Parsed parsed(test::default_frame(accelerator));
    ASSERT_TRUE(std::holds_alternative<Frame>(parsed.request().what));
    EXPECT_EQ(*std::get<Frame>(parsed.request().what).state, initial_state(accelerator));
    EXPECT_EQ(parsed.request().effect, Effect::Writes);
}

TEST(TypedRequest, SetGivesThePresentStateChanged)
{
    const Parsed parsed("set zm=4");
    ASSERT_NE(parsed.command<"SET">(), nullptr);
    State expected = initial_state(accelerator);
    expected.codes[marcher::ZM] = 4 << 24;
    EXPECT_EQ(*std::get<0>(parsed.command<"SET">()->values), expected);
}

TEST(TypedRequest, ViewGivesItsNumbers)
{
    const Parsed parsed("VIEW  -90 , +89.9,1e1");
    ASSERT_NE(parsed.command<"VIEW">(), nullptr);
    const auto [yaw, pitch, zoom] = parsed.command<"VIEW">()->values;
    EXPECT_EQ(yaw, -90.0);
    EXPECT_EQ(pitch, 89.9);
    EXPECT_EQ(zoom, 10 << 24);
}

TEST(TypedRequest, HueGivesItsNumber)
{
    ASSERT_NE(Parsed("HUE 0.25").command<"HUE">(), nullptr);
    EXPECT_EQ(std::get<0>(Parsed("HUE 0.25").command<"HUE">()->values), 0.25);
    EXPECT_EQ(std::get<0>(Parsed("HUE 1e-999").command<"HUE">()->values), 0.0); // below any double
}

TEST(TypedRequest, GetGivesItsKeysInOrder)
{
    const Parsed parsed("GET zm, FX");
    ASSERT_NE(parsed.command<"GET">(), nullptr);
    const auto& [keys] = parsed.command<"GET">()->values;
    ASSERT_TRUE(keys);
    ASSERT_EQ(keys->indices.size(), 2U);
    EXPECT_EQ(keys->indices[0], marcher::ZM);
    EXPECT_EQ(keys->indices[1], marcher::FX);
    ASSERT_NE(Parsed("GET").command<"GET">(), nullptr);
    EXPECT_FALSE(std::get<0>(Parsed("GET").command<"GET">()->values));
}

TEST(TypedRequest, WordsThatNameSomething)
{
    EXPECT_EQ(std::get<0>(Parsed("RESET Camera").command<"RESET">()->values), "camera");
    EXPECT_EQ(std::get<0>(Parsed("RANDOM").command<"RANDOM">()->values), std::nullopt);
    EXPECT_EQ(std::get<0>(Parsed("ACCELERATOR FRACTAL").command<"ACCELERATOR">()->values),
              find_accelerator("fractal"));
    EXPECT_EQ(std::get<0>(Parsed("HELP  what is it ").command<"HELP">()->values), "what is it");
    EXPECT_EQ(std::get<0>(Parsed("ECHO Off").command<"ECHO">()->values), 1U);
    for (std::size_t i = 0; i < accelerator.presets.size(); ++i)
        EXPECT_EQ(std::get<0>(Parsed("PRESET " + std::string(accelerator.presets[i].name))
                                  .command<"PRESET">()
                                  ->values),
                  i);
}

struct StepsRow
{
    std::string_view words;
    std::size_t direction;
    std::optional<unsigned> steps;
};

constexpr std::array walk_rows = {
    StepsRow{"forward", 0, std::nullopt}, StepsRow{"down", 5, std::nullopt},
    StepsRow{"FORWARD 3", 0, 3},          StepsRow{"Back \t 1000", 1, 1000},
    StepsRow{"left 007", 2, 7},
};

TEST(TypedRequest, WalkGivesDirectionAndSteps)
{
    for (const StepsRow& row : walk_rows) {
        const Parsed parsed("WALK " + std::string(row.words));
        ASSERT_NE(parsed.command<"WALK">(), nullptr) << row.words;
        EXPECT_EQ(std::get<0>(parsed.command<"WALK">()->values), row.direction) << row.words;
        EXPECT_EQ(std::get<1>(parsed.command<"WALK">()->values), row.steps) << row.words;
    }
    for (std::size_t i = 0; i < turn_directions.size(); ++i) {
        const Parsed parsed("TURN " + std::string(turn_directions[i]) + " 1");
        ASSERT_NE(parsed.command<"TURN">(), nullptr);
        EXPECT_EQ(std::get<0>(parsed.command<"TURN">()->values), i);
    }
}

struct EffectRow
{
    std::string_view line;
    std::optional<Effect> effect;
};

constexpr std::array effect_rows = {
    EffectRow{"PRESET", Effect::Reads},
    EffectRow{"PRESET nothing", Effect::Writes}, // known, although the preset is not
    EffectRow{"ACCELERATOR", Effect::Reads},
    EffectRow{"SET", Effect::Writes},
    EffectRow{"SET FX=9", Effect::Writes},
    EffectRow{"GET", Effect::Reads},
    EffectRow{"NOTHING", std::nullopt},
    EffectRow{"PING*00", std::nullopt},
    EffectRow{"FX=", Effect::Writes},
};

TEST(TypedRequest, TheEffectIsKnownOfWhatIsRefusedToo)
{
    for (const EffectRow& row : effect_rows)
        EXPECT_EQ(Parsed(row.line).request().effect, row.effect) << row.line;
}

struct FaultRow
{
    std::string_view line;
    std::size_t column;
    std::string_view allowed{}; ///< empty where the reply tells what the code or a bound says
};

constexpr std::array fault_rows = {
    FaultRow{"PING x", 6},
    FaultRow{"PING  ,", 7},
    FaultRow{"SET", 4},
    FaultRow{"  SET  ", 6}, // the end of the text
    FaultRow{"HUE", 4},
    FaultRow{"HUE red", 5},
    FaultRow{"HUE 1.0000000000000000000001", 5},
    FaultRow{"HUE -0.1", 5},
    FaultRow{"HUE 0,0", 7, "HUE takes one number"},
    FaultRow{"HUE 0,", 7, "HUE takes one number"},
    FaultRow{"RESET camera light", 14, "one group, or none for all"},
    FaultRow{"RESET nothing light", 7, "HELP RESET names the groups"},
    FaultRow{"RANDOM nothing", 8, "HELP RESET names the groups"},
    FaultRow{"PRESET tunnel x", 8, "PRESET alone lists the presets"},
    FaultRow{"ACCELERATOR none", 13, "HELP ACCELERATOR names the accelerators"},
    FaultRow{"ECHO maybe so", 6, "ECHO takes on or off"},
    FaultRow{"ECHO on  off", 10, "ECHO takes on or off"},
    FaultRow{"WALK sideways", 6, "HELP WALK names the directions"},
    FaultRow{"WALK sideways 0", 15}, // the number is read first
    FaultRow{"TURN forward", 6, "HELP TURN names the directions"},
    FaultRow{"ANIMATE maybe", 9, "ANIMATE takes on or off"},
    FaultRow{"ANIMATE maybe 61", 15},
    FaultRow{"ANIMATE maybe 60", 9, "ANIMATE takes on or off"},
    FaultRow{"ANIMATE off 0", 13},
    FaultRow{"ANIMATE off 1", 13, "ANIMATE off takes no rate"},
    FaultRow{"GET FX,FX", 8, "GET takes the keys of parameters, each once"},
    FaultRow{"GET FX,", 8, "GET takes the keys of parameters, each once"},
};

TEST(TypedRequest, FaultsHaveTheirColumnAndSentence)
{
    for (const FaultRow& row : fault_rows) {
        const Parsed parsed(row.line);
        ASSERT_NE(parsed.fault(), nullptr) << row.line;
        EXPECT_EQ(parsed.fault()->code, ErrorCode::Argument) << row.line;
        EXPECT_EQ(parsed.fault()->column, row.column) << row.line;
        EXPECT_EQ(parsed.fault()->allowed, row.allowed) << row.line;
    }
}

struct BadArguments
{
    std::string_view words;
    std::size_t column;
    bool names_zoom;
};

constexpr std::array view_faults = {
    BadArguments{"", 1, false},
    BadArguments{"1", 2, false},
    BadArguments{"1,2", 4, true},
    BadArguments{"1,2,", 5, true},
    BadArguments{"x,2,3", 1, false},
    BadArguments{"1000000.0000000000000000001,0,3", 1, false},
    BadArguments{"0,89.90000000000000000000001,3", 3, false},
    BadArguments{"0,-90,3", 3, false},
    BadArguments{"0, 0 , 10.00000000001", 8, true},
    BadArguments{"0,0,-0.1", 5, true},
    BadArguments{"0,0,1,", 7, false},
    BadArguments{"0,0,1, 2", 8, false},
};

TEST(TypedRequest, FaultsOfView)
{
    for (const BadArguments& row : view_faults) {
        const std::string line = "VIEW " + std::string(row.words);
        const Parsed parsed(line);
        ASSERT_NE(parsed.fault(), nullptr) << line;
        EXPECT_EQ(parsed.fault()->code, ErrorCode::Argument) << line;
        EXPECT_EQ(parsed.fault()->column, row.words.empty() ? 5 : row.column + 5) << line;
        EXPECT_EQ(parsed.fault()->parameter.has_value(), row.names_zoom) << line;
    }
}

class EveryCommand : public test::EveryAccelerator
{};
INSTANTIATE_TEST_SUITE_P(Accelerators, EveryCommand, testing::ValuesIn(accelerators),
                         test::accelerator_name);

TEST_P(EveryCommand, ViewAndHueAreForThoseThatHaveTheParameters)
{
    const Parsed view("VIEW 30,20,3", accelerator);
    EXPECT_EQ(view.fault() != nullptr, !accelerator.camera);
    const Parsed hue("HUE 0.25", accelerator);
    EXPECT_EQ(hue.fault() != nullptr, !accelerator.colour);
    for (const Fault* const fault : {view.fault(), hue.fault()}) {
        if (fault != nullptr) {
            EXPECT_EQ(fault->code, ErrorCode::Argument);
            EXPECT_EQ(fault->column, fault == hue.fault() ? 5U : 6U);
            EXPECT_FALSE(fault->allowed.empty());
        }
    }
}

} // namespace
} // namespace raymarch::protocol
