// SPDX-License-Identifier: MIT
#include "motion/colour.hpp"
#include "motion/orbit_camera.hpp"
#include "motion/random_values.hpp"
#include "protocol/accelerators/marcher.hpp"
#include "protocol/assignments.hpp"
#include "tests/fakes/descriptions.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <random>
#include <string>
#include <string_view>

namespace raymarch::motion
{
namespace
{

using namespace protocol; // NOLINT(google-build-using-namespace): the tests set parameters

constexpr const Accelerator& accelerator = protocol::marcher::description;

/// The nearest code, or one beside it where the exact value lies within 10^-6 units of a tie.
void expect_near(std::int64_t code, long double value, const std::string& what)
{
    const long double exact = std::min(value * 131072, 131071.0L);
    EXPECT_LE(std::fabs(static_cast<long double>(code) - exact), 0.5L + 1e-6L) << what;
}

TEST(OrbitCamera, AgreesWithTheFormulaInLongDouble)
{
    auto random = test::seeded_random();
    for (int i = 0; i < 5000; ++i) {
        const std::string yaw = std::to_string(test::pick(random, -720'000, 720'000)) + "e-3";
        const std::string pitch = std::to_string(test::pick(random, -89'900, 89'900)) + "e-3";
        State state = initial_state(accelerator);
        set_orbit(accelerator, std::stod(yaw), std::stod(pitch), state);
        constexpr long double radians = std::numbers::pi_v<long double> / 180;
        const long double a = std::stold(yaw) * radians;
        const long double p = std::stold(pitch) * radians;
        const std::string what = yaw + "," + pitch;
        expect_near(state.codes[protocol::marcher::FX], std::cos(p) * std::sin(a), what + " FX");
        expect_near(state.codes[protocol::marcher::FY], std::sin(p), what + " FY");
        expect_near(state.codes[protocol::marcher::FZ], std::cos(p) * std::cos(a), what + " FZ");
        // (0,1,0) x F = (Fz, 0, -Fx), of length cos p
        expect_near(state.codes[protocol::marcher::RX], std::cos(a), what + " RX");
        expect_near(state.codes[protocol::marcher::RY], 0, what + " RY");
        expect_near(state.codes[protocol::marcher::RZ], -std::sin(a), what + " RZ");
        expect_near(state.codes[protocol::marcher::UX], -std::sin(p) * std::sin(a), what + " UX");
        expect_near(state.codes[protocol::marcher::UY], std::cos(p), what + " UY");
        expect_near(state.codes[protocol::marcher::UZ], -std::sin(p) * std::cos(a), what + " UZ");
        ASSERT_TRUE(basis_is_orthonormal(accelerator, state)) << what;
    }
}

struct HueRow
{
    double hue;
    std::array<int, 3> rgb; ///< codes
};

constexpr std::array hue_rows = {
    HueRow{0, {1023, 0, 0}},
    HueRow{0.25, {512, 1023, 0}}, // half way between yellow and green
    HueRow{0.5, {0, 1023, 1023}},
    HueRow{0.75, {512, 0, 1023}},
    HueRow{1, {1023, 0, 0}},                     // red again
    HueRow{0.1666666666666666, {1023, 1023, 0}}, // yellow from below: held at 1023
    HueRow{0.1666666666666667, {1023, 1023, 0}}, // and from above
    HueRow{0.3333333333333333, {0, 1023, 0}},
    HueRow{0.3333333333333334, {0, 1023, 0}},
    HueRow{0.6666666666666666, {0, 0, 1023}},
    HueRow{0.8333333333333334, {1023, 0, 1023}},
    HueRow{1e-300, {1023, 0, 0}},
};

TEST(Hue, TheCornersOfTheWheel)
{
    for (const HueRow& row : hue_rows) {
        State state = initial_state(accelerator);
        set_hue(accelerator, row.hue, state);
        EXPECT_EQ(state.codes[protocol::marcher::R], row.rgb[0]) << row.hue;
        EXPECT_EQ(state.codes[protocol::marcher::G], row.rgb[1]) << row.hue;
        EXPECT_EQ(state.codes[protocol::marcher::B], row.rgb[2]) << row.hue;
        EXPECT_EQ(state.codes[protocol::marcher::ZM],
                  initial_state(accelerator).codes[protocol::marcher::ZM]);
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
        if (p == protocol::marcher::RY) // an orbit's right is level
            continue;
        EXPECT_LT(least.codes[p], most.codes[p]) << accelerator.parameters[p].key;
    }
    EXPECT_EQ(least.codes[protocol::marcher::OBJ], 0);
    EXPECT_EQ(most.codes[protocol::marcher::OBJ], 3);
}

class RandomGroups : public test::EveryAccelerator
{};
INSTANTIATE_TEST_SUITE_P(Accelerators, RandomGroups, testing::ValuesIn(accelerators),
                         test::accelerator_name);

TEST_P(RandomGroups, RandomStatesAreInsideTheRanges)
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

TEST_P(RandomGroups, ARandomGroupLeavesTheOthersAlone)
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

} // namespace
} // namespace raymarch::motion
