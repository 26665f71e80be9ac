// SPDX-License-Identifier: MIT
#include "protocol/parameters.hpp"

#include "protocol/accelerators.hpp"
#include "protocol/assignments.hpp"
#include "protocol/quantizer.hpp"

#include <gtest/gtest.h>

#include <array>
#include <set>
#include <string_view>

namespace raymarch::protocol
{
namespace
{

struct FormatRow
{
    Format format;
    int width;
    std::int64_t min;
    std::int64_t max;
};

constexpr std::array formats = {
    FormatRow{signed_q(1, 17), 18, -131072, 131071},
    FormatRow{signed_q(7, 3), 10, -512, 511},
    FormatRow{unsigned_q(8, 24), 32, 0, 0xFFFF'FFFF},
    FormatRow{unsigned_q(0, 10), 10, 0, 1023},
    FormatRow{unsigned_q(2, 0), 2, 0, 3},
    FormatRow{signed_q(8, 24), 32, INT32_MIN, INT32_MAX},
};

TEST(Format, WidthAndCodes)
{
    for (const FormatRow& row : formats) {
        EXPECT_EQ(row.format.width(), row.width);
        EXPECT_EQ(row.format.min_code(), row.min) << row.width;
        EXPECT_EQ(row.format.max_code(), row.max) << row.width;
    }
}

TEST(Parameters, KeysAreFoundFromAnyGuess)
{
    const auto table = marcher::description.parameters;
    for (std::size_t i = 0; i < table.size(); ++i)
        for (std::size_t guess = 0; guess <= table.size() + 1; ++guess)
            EXPECT_EQ(find_parameter(table, table[i].key, guess), i) << table[i].key;
    EXPECT_EQ(find_parameter(table, "obj"), marcher::OBJ);
    EXPECT_FALSE(find_parameter(table, ""));
    EXPECT_FALSE(find_parameter(table, "F"));
}

TEST(Parameters, ChoicesHaveANameAndADigit)
{
    const Parameter& scene = marcher::parameters[marcher::OBJ];
    EXPECT_EQ(find_choice(scene, "Infinite_Cube"), 2);
    EXPECT_EQ(find_choice(scene, "3"), 3);
    for (const std::string_view text : {"", "4", "03", "+1", "cub", "cube ", "-0"})
        EXPECT_FALSE(find_choice(scene, text)) << text;
}

/// The contract of the marcher, once more by hand: range and default of each group of keys.
struct RangeRow
{
    std::string_view keys;
    std::string_view group;
    std::string_view min;
    std::string_view max;
    int width;
};

constexpr std::array ranges = {
    RangeRow{"FX FY FZ RX RY RZ UX UY UZ", "camera", "-1", "1", 18},
    RangeRow{"ZM", "camera", "0", "10", 32},
    RangeRow{"LX LY LZ", "light", "-64", "63.875", 10},
    RangeRow{"R G B", "colour", "0", "1", 10},
    RangeRow{"OBJ", "object", "", "", 2},
};

TEST(Marcher, RangesAreThoseOfTheContract)
{
    std::size_t count = 0;
    for (const RangeRow& row : ranges) {
        Text rest{.bytes = row.keys};
        while (!rest.empty()) {
            const auto key = take_until(rest, ' ').text.bytes;
            const auto index = find_parameter(marcher::parameters, key);
            ASSERT_TRUE(index) << key;
            const Parameter& parameter = marcher::parameters[*index];
            EXPECT_EQ(parameter.group, row.group) << key;
            EXPECT_EQ(parameter.min, row.min) << key;
            EXPECT_EQ(parameter.max, row.max) << key;
            EXPECT_EQ(parameter.format.width(), row.width) << key;
            ++count;
        }
    }
    EXPECT_EQ(count, marcher::parameters.size());
}

TEST(Marcher, BothEndsOfEachRangeAreAccepted)
{
    for (const Parameter& parameter : marcher::parameters) {
        if (parameter.is_choice())
            continue;
        EXPECT_TRUE(quantize(parameter, parameter.min)) << parameter.key;
        EXPECT_TRUE(quantize(parameter, parameter.max)) << parameter.key;
        EXPECT_EQ(quantize(parameter, parameter.initial), parameter.initial_code) << parameter.key;
    }
}

TEST(Marcher, PresetsAreReadAndHaveARealCamera)
{
    std::array<int, marcher::scenes.size()> views{};
    std::set<std::string_view> names;
    for (const Preset& preset : marcher::presets) {
        State state = initial_state(marcher::description);
        ParameterSet given;
        EXPECT_FALSE(
            read_assignments(marcher::description, {.bytes = preset.settings}, state, given))
            << preset.name;
        EXPECT_TRUE(basis_is_orthonormal(marcher::description, state)) << preset.name;
        EXPECT_TRUE(names.insert(preset.name).second) << preset.name;
        EXPECT_FALSE(preset.summary.empty()) << preset.name;
        ++views[static_cast<std::size_t>(state.codes[marcher::OBJ])];
    }
    for (std::size_t scene = 0; scene < views.size(); ++scene)
        EXPECT_GE(views[scene], 2) << marcher::scenes[scene];
}

} // namespace
} // namespace raymarch::protocol
