// SPDX-License-Identifier: MIT
#include "protocol/arguments.hpp"

#include "protocol/assignments.hpp"
#include "tests/fakes/descriptions.hpp"
#include "tests/protocol/accelerator.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <set>
#include <string>
#include <string_view>

namespace raymarch::protocol
{
namespace
{

State view(std::string_view words)
{
    State state = initial_state(accelerator);
    EXPECT_FALSE(apply_view(accelerator, {.bytes = words}, state)) << words;
    return state;
}

/// The nearest code, or one beside it where the exact value lies within 10^-6 units of a tie.
void expect_near(std::int64_t code, long double value, const std::string& what)
{
    const long double exact = std::min(value * 131072, 131071.0L);
    EXPECT_LE(std::fabs(static_cast<long double>(code) - exact), 0.5L + 1e-6L) << what;
}

TEST(View, AgreesWithTheFormulaInLongDouble)
{
    auto random = test::seeded_random();
    for (int i = 0; i < 5000; ++i) {
        const std::string yaw = std::to_string(test::pick(random, -720'000, 720'000)) + "e-3";
        const std::string pitch = std::to_string(test::pick(random, -89'900, 89'900)) + "e-3";
        const State state = view(yaw + "," + pitch + ",3");
        constexpr long double radians = std::numbers::pi_v<long double> / 180;
        const long double a = std::stold(yaw) * radians;
        const long double p = std::stold(pitch) * radians;
        const std::string what = yaw + "," + pitch;
        expect_near(state.codes[marcher::FX], std::cos(p) * std::sin(a), what + " FX");
        expect_near(state.codes[marcher::FY], std::sin(p), what + " FY");
        expect_near(state.codes[marcher::FZ], std::cos(p) * std::cos(a), what + " FZ");
        // (0,1,0) x F = (Fz, 0, -Fx), of length cos p
        expect_near(state.codes[marcher::RX], std::cos(a), what + " RX");
        expect_near(state.codes[marcher::RY], 0, what + " RY");
        expect_near(state.codes[marcher::RZ], -std::sin(a), what + " RZ");
        expect_near(state.codes[marcher::UX], -std::sin(p) * std::sin(a), what + " UX");
        expect_near(state.codes[marcher::UY], std::cos(p), what + " UY");
        expect_near(state.codes[marcher::UZ], -std::sin(p) * std::cos(a), what + " UZ");
        ASSERT_TRUE(basis_is_orthonormal(accelerator, state)) << what;
    }
}

TEST(View, SetsTheZoomByItsOwnParameter)
{
    EXPECT_EQ(view("0,0,10").codes[marcher::ZM], 167'772'160);
    EXPECT_EQ(view("0,0,0").codes[marcher::ZM], 0);
    EXPECT_EQ(view(" +0.0 , -0 , 1e0 ").codes[marcher::ZM], 1 << 24);
}

TEST(View, LeavesLightColourAndSceneAlone)
{
    const State state = view("12,34,5");
    const State initial = initial_state(accelerator);
    for (const std::size_t i :
         {marcher::LX, marcher::LY, marcher::LZ, marcher::R, marcher::G, marcher::B, marcher::OBJ})
        EXPECT_EQ(state.codes[i], initial.codes[i]) << accelerator.parameters[i].key;
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

TEST(View, FaultsLeaveTheStateAlone)
{
    for (const BadArguments& row : view_faults) {
        State state = initial_state(accelerator);
        const auto fault = apply_view(accelerator, {.bytes = row.words}, state);
        ASSERT_TRUE(fault) << row.words;
        EXPECT_EQ(fault->code, ErrorCode::Argument) << row.words;
        EXPECT_EQ(fault->column, row.column) << row.words;
        EXPECT_EQ(fault->parameter.has_value(), row.names_zoom) << row.words;
        EXPECT_EQ(state, initial_state(accelerator)) << row.words;
    }
}

struct HueRow
{
    std::string_view hue;
    std::array<int, 3> rgb; ///< codes
};

constexpr std::array hue_rows = {
    HueRow{"0", {1023, 0, 0}},
    HueRow{"0.25", {512, 1023, 0}}, // half way between yellow and green
    HueRow{"0.5", {0, 1023, 1023}},
    HueRow{"0.75", {512, 0, 1023}},
    HueRow{"1", {1023, 0, 0}},                     // red again
    HueRow{"0.1666666666666666", {1023, 1023, 0}}, // yellow from below: held at 1023
    HueRow{"0.1666666666666667", {1023, 1023, 0}}, // and from above
    HueRow{"0.3333333333333333", {0, 1023, 0}},
    HueRow{"0.3333333333333334", {0, 1023, 0}},
    HueRow{"0.6666666666666666", {0, 0, 1023}},
    HueRow{"0.8333333333333334", {1023, 0, 1023}},
    HueRow{"1e-999", {1023, 0, 0}}, // too small for a double
};

TEST(Hue, TheCornersOfTheWheel)
{
    for (const HueRow& row : hue_rows) {
        State state = initial_state(accelerator);
        ASSERT_FALSE(apply_hue(accelerator, {.bytes = row.hue}, state)) << row.hue;
        EXPECT_EQ(state.codes[marcher::R], row.rgb[0]) << row.hue;
        EXPECT_EQ(state.codes[marcher::G], row.rgb[1]) << row.hue;
        EXPECT_EQ(state.codes[marcher::B], row.rgb[2]) << row.hue;
        EXPECT_EQ(state.codes[marcher::ZM], initial_state(accelerator).codes[marcher::ZM]);
    }
}

TEST(Hue, Faults)
{
    for (const std::string_view words :
         {"", "red", "1.0000000000000000000001", "-0.1", "0,0", "0,"}) {
        State state = initial_state(accelerator);
        const auto fault = apply_hue(accelerator, {.bytes = words}, state);
        ASSERT_TRUE(fault) << words;
        EXPECT_EQ(fault->code, ErrorCode::Argument) << words;
        EXPECT_EQ(state, initial_state(accelerator)) << words;
    }
}

void expect_in_range(const State& state)
{
    for (std::size_t i = 0; i < accelerator.parameters.size(); ++i) {
        const Parameter& parameter = accelerator.parameters[i];
        EXPECT_GE(state.codes[i], parameter.min_scaled) << parameter.key;
        EXPECT_LE(state.codes[i], std::min(parameter.max_scaled, parameter.format.max_code()))
            << parameter.key;
    }
}

TEST(Random, StatesAreInsideTheRangesAndHaveARealCamera)
{
    auto random = test::seeded_random();
    State least = initial_state(accelerator);
    State most = least;
    for (int i = 0; i < 2000; ++i) {
        State state;
        randomise(accelerator, "", random, state);
        expect_in_range(state);
        ASSERT_TRUE(basis_is_orthonormal(accelerator, state));
        for (std::size_t p = 0; p < accelerator.parameters.size(); ++p) {
            least.codes[p] = std::min(least.codes[p], state.codes[p]);
            most.codes[p] = std::max(most.codes[p], state.codes[p]);
        }
    }
    for (std::size_t p = 0; p < accelerator.parameters.size(); ++p) {
        if (p == marcher::RY) // an orbit's right is level
            continue;
        EXPECT_LT(least.codes[p], most.codes[p]) << accelerator.parameters[p].key;
    }
    EXPECT_EQ(least.codes[marcher::OBJ], 0);
    EXPECT_EQ(most.codes[marcher::OBJ], 3);
}

class Groups : public test::EveryAccelerator
{
  protected:
    [[nodiscard]] std::set<std::string_view> groups() const
    {
        std::set<std::string_view> names;
        for (const Parameter& parameter : table)
            names.insert(parameter.group);
        return names;
    }
};
INSTANTIATE_TEST_SUITE_P(Accelerators, Groups, testing::ValuesIn(accelerators),
                         test::accelerator_name);

TEST_P(Groups, AreFoundInAnyCase)
{
    for (const std::string_view group : groups()) {
        EXPECT_EQ(find_group(accelerator, group), group);
        std::string upper(group);
        std::ranges::transform(upper, upper.begin(), to_upper);
        EXPECT_EQ(find_group(accelerator, upper), group);
    }
    EXPECT_FALSE(find_group(accelerator, ""));
    EXPECT_FALSE(find_group(accelerator, "nothing"));
}

TEST_P(Groups, RandomStatesAreInsideTheRanges)
{
    auto random = test::seeded_random();
    for (int i = 0; i < 200; ++i) {
        State state = initial_state(accelerator);
        randomise(accelerator, "", random, state);
        for (std::size_t p = 0; p < table.size(); ++p) {
            ASSERT_GE(state.codes[p], table[p].min_scaled) << table[p].key;
            ASSERT_LE(state.codes[p], test::largest_in_range(table[p])) << table[p].key;
        }
        ASSERT_TRUE(basis_is_orthonormal(accelerator, state));
    }
}

TEST_P(Groups, ARandomGroupLeavesTheOthersAlone)
{
    auto random = test::seeded_random();
    const State initial = initial_state(accelerator);
    for (const std::string_view group : groups()) {
        bool changed = false;
        for (int i = 0; i < 50; ++i) {
            State state = initial;
            randomise(accelerator, group, random, state);
            for (std::size_t p = 0; p < table.size(); ++p) {
                const bool same = state.codes[p] == initial.codes[p];
                EXPECT_TRUE(same || table[p].group == group) << table[p].key << " by " << group;
                changed |= !same;
            }
        }
        EXPECT_TRUE(changed) << group;
    }
}

TEST_P(Groups, AreResetOneByOneOrAll)
{
    auto random = test::seeded_random();
    const State changed = test::random_state(accelerator, random);
    for (const std::string_view group : groups()) {
        State state = changed;
        reset(accelerator, group, state);
        for (std::size_t p = 0; p < table.size(); ++p)
            EXPECT_EQ(state.codes[p],
                      table[p].group == group ? table[p].initial_code : changed.codes[p])
                << table[p].key << " by " << group;
    }
    State state = changed;
    reset(accelerator, "", state);
    EXPECT_EQ(state, initial_state(accelerator));
}

TEST_P(Groups, ViewAndHueAreForThoseThatHaveTheParameters)
{
    const State initial = initial_state(accelerator);
    State state = initial;
    const auto view_fault = apply_view(accelerator, {.bytes = "30,20,3"}, state);
    ASSERT_EQ(view_fault.has_value(), !accelerator.camera.has_value());
    EXPECT_EQ(state == initial, view_fault.has_value());
    EXPECT_TRUE(basis_is_orthonormal(accelerator, state));
    state = initial;
    const auto hue_fault = apply_hue(accelerator, {.bytes = "0.25"}, state);
    ASSERT_EQ(hue_fault.has_value(), !accelerator.colour.has_value());
    EXPECT_EQ(state == initial, hue_fault.has_value());
    for (const auto& fault : {view_fault, hue_fault}) {
        if (fault) {
            EXPECT_EQ(fault->code, ErrorCode::Argument);
            EXPECT_EQ(fault->column, 1U);
            EXPECT_FALSE(fault->allowed.empty());
        }
    }
}

TEST(Random, TheSameSeedDrawsTheSameState)
{
    std::mt19937_64 first(7);
    std::mt19937_64 second(7);
    State a;
    State b;
    randomise(accelerator, "", first, a);
    randomise(accelerator, "", second, b);
    EXPECT_EQ(a, b);
}

TEST(MarcherGroups, AreCalledAsTheContractSays)
{
    EXPECT_EQ(find_group(accelerator, "CAMERA"), "camera");
    EXPECT_EQ(find_group(accelerator, "Colour"), "colour");
    EXPECT_FALSE(find_group(accelerator, ""));
    EXPECT_FALSE(find_group(accelerator, "color"));
    EXPECT_FALSE(find_group(accelerator, "FX"));
}

} // namespace
} // namespace raymarch::protocol
