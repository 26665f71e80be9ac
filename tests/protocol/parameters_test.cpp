// SPDX-License-Identifier: MIT
#include "protocol/parameters.hpp"

#include "protocol/accelerators.hpp"
#include "protocol/assignments.hpp"
#include "protocol/quantizer.hpp"
#include "tests/fakes/descriptions.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace raymarch::protocol
{
namespace
{

// Constants in every build, those of the sanitizers too.
static_assert(position_of(marcher::description) == 0 && position_of(whitted::description) == 4);

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

class Parameters : public test::EveryAccelerator
{};
INSTANTIATE_TEST_SUITE_P(Accelerators, Parameters, testing::ValuesIn(accelerators),
                         test::accelerator_name);

TEST_P(Parameters, KeysAreFoundFromAnyGuess)
{
    for (std::size_t i = 0; i < table.size(); ++i)
        for (std::size_t guess = 0; guess <= table.size() + 1 && !table[i].is_tail(); ++guess)
            ASSERT_EQ(find_parameter(accelerator, table[i].key, guess), i) << table[i].key;
    EXPECT_FALSE(find_parameter(accelerator, ""));
}

TEST_P(Parameters, TheDescriptionHoldsTogether)
{
    EXPECT_EQ(accelerators[accelerator.kind], &accelerator) << "kinds count from 0";
    EXPECT_EQ(find_accelerator(accelerator.name), &accelerator);
    EXPECT_EQ(position_of(accelerator), accelerator.kind);
    if (accelerator.camera) { // basis_is_orthonormal() multiplies codes of at most 32 bits
        for (const auto& direction :
             {accelerator.camera->forward, accelerator.camera->right, accelerator.camera->up})
            for (const ParameterIndex i : direction)
                EXPECT_LE(table[i].code_width(), 32) << table[i].key;
    }
    EXPECT_LE(accelerator.size.width, accelerator.max_size.width);
    EXPECT_LE(accelerator.size.height, accelerator.max_size.height);
    EXPECT_GT(accelerator.clock_hz, 0U);
    EXPECT_GT(accelerator.ray_units, 0);
    for (std::size_t i = 0; i < table.size(); ++i) {
        const Parameter& parameter = table[i];
        EXPECT_FALSE(parameter.meaning.empty()) << parameter.key;
        EXPECT_FALSE(parameter.group.empty()) << parameter.key;
        EXPECT_EQ(accelerator.frame[i], !parameter.is_row() && !parameter.is_tail())
            << parameter.key;
    }
}

TEST_P(Parameters, EveryChoiceHasANameAndADigit)
{
    for (const Parameter& parameter : table) {
        for (std::size_t code = 0; code < parameter.choices.size(); ++code) {
            std::string name(parameter.choices[code]);
            EXPECT_EQ(find_choice(parameter, name), code) << parameter.key << '=' << name;
            std::ranges::transform(name, name.begin(), to_upper);
            EXPECT_EQ(find_choice(parameter, name), code) << parameter.key << '=' << name;
            EXPECT_EQ(find_choice(parameter, std::to_string(code)), code) << parameter.key;
            EXPECT_FALSE(find_choice(parameter, name + " ")) << parameter.key;
        }
        EXPECT_FALSE(find_choice(parameter, std::to_string(parameter.choices.size())))
            << parameter.key;
        EXPECT_FALSE(find_choice(parameter, "")) << parameter.key;
    }
}

TEST_P(Parameters, EndsAndDefaultsAreAccepted)
{
    for (const Parameter& parameter : table) {
        if (parameter.is_choice() || parameter.tail_bits > 0 || parameter.is_tail())
            continue;
        EXPECT_EQ(quantize(parameter, parameter.min), parameter.min_scaled) << parameter.key;
        EXPECT_EQ(quantize(parameter, parameter.max),
                  std::min(parameter.max_scaled, parameter.largest_code))
            << parameter.key;
        EXPECT_EQ(quantize(parameter, parameter.initial), parameter.initial_code) << parameter.key;
    }
}

TEST_P(Parameters, EndsAndDefaultsOfWideNumbersAreAccepted)
{
    for (const Parameter& parameter : table) {
        if (parameter.tail_bits == 0)
            continue;
        const auto code = [](std::int64_t upper) { return WideCode{.upper = upper, .tail = 0}; };
        EXPECT_EQ(quantize_wide(parameter, parameter.min), code(parameter.min_scaled));
        EXPECT_EQ(quantize_wide(parameter, parameter.max), code(parameter.max_scaled));
        EXPECT_EQ(quantize_wide(parameter, parameter.initial), code(parameter.initial_code));
    }
}

TEST_P(Parameters, PresetsAreReadAndDiffer)
{
    std::vector<State> views;
    std::set<std::string_view> names;
    for (const Preset& preset : accelerator.presets) {
        State state = initial_state(accelerator);
        ParameterSet given;
        EXPECT_FALSE(read_assignments(accelerator, {.bytes = preset.settings}, state, given))
            << preset.name; // an empty one would be no assignment
        EXPECT_TRUE(basis_is_orthonormal(accelerator, state)) << preset.name;
        EXPECT_TRUE(names.insert(preset.name).second) << preset.name;
        EXPECT_EQ(preset.name.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789_"),
                  std::string_view::npos)
            << preset.name;
        EXPECT_FALSE(preset.summary.empty()) << preset.name;
        EXPECT_EQ(std::ranges::count(views, state), 0) << preset.name << " is another one again";
        views.push_back(state);
    }
    EXPECT_FALSE(views.empty());
}

TEST(MarcherParameters, KeysAreFoundInAnyCase)
{
    EXPECT_EQ(find_parameter(marcher::description, "obj"), marcher::OBJ);
    EXPECT_EQ(find_parameter(marcher::description, "Obj", marcher::FX), marcher::OBJ);
    for (const std::string_view key : {"", "F", "FXX", "XF", "OB", "fx="})
        EXPECT_FALSE(find_parameter(marcher::description, key)) << key;
}

TEST(MarcherParameters, ChoicesHaveANameAndADigit)
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

TEST(MarcherParameters, RangesAreThoseOfTheContract)
{
    std::size_t count = 0;
    for (const RangeRow& row : ranges) {
        Text rest{.bytes = row.keys};
        while (!rest.empty()) {
            const auto key = take_until(rest, ' ').text.bytes;
            const auto index = find_parameter(marcher::description, key);
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

TEST(MarcherParameters, PresetsShowEveryScene)
{
    std::array<int, marcher::scenes.size()> views{};
    for (const Preset& preset : marcher::presets) {
        State state = initial_state(marcher::description);
        ParameterSet given;
        EXPECT_FALSE(
            read_assignments(marcher::description, {.bytes = preset.settings}, state, given));
        ++views[static_cast<std::size_t>(state.codes[marcher::OBJ])];
    }
    for (std::size_t scene = 0; scene < views.size(); ++scene)
        EXPECT_GE(views[scene], 2) << marcher::scenes[scene];
}

} // namespace
} // namespace raymarch::protocol
