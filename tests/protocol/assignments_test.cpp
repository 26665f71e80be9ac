// SPDX-License-Identifier: MIT
#include "protocol/assignments.hpp"

#include "protocol/accelerators.hpp"
#include "protocol/reply.hpp"
#include "tests/fakes/descriptions.hpp"
#include "tests/protocol/accelerator.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <string>
#include <string_view>

namespace raymarch::protocol
{
namespace
{

// The tests with numbers typed by hand are the marcher's.

struct BadAssignment
{
    std::string_view text;
    ErrorCode code;
    std::size_t column;
    std::string_view key; ///< of the parameter, or the unknown word
};

constexpr std::array bad_assignments = {
    BadAssignment{"", ErrorCode::Syntax, 1, ""},
    BadAssignment{"FX", ErrorCode::Syntax, 1, ""},
    BadAssignment{"=0", ErrorCode::Syntax, 1, ""},
    BadAssignment{"FX=0,", ErrorCode::Syntax, 6, ""},
    BadAssignment{",FX=0", ErrorCode::Syntax, 1, ""},
    BadAssignment{"FX=0,,FY=0", ErrorCode::Syntax, 6, ""},
    BadAssignment{"F X=0", ErrorCode::Syntax, 1, ""},
    BadAssignment{"F1=0", ErrorCode::Syntax, 1, ""}, // keys are letters
    BadAssignment{"FX=0, FQ =1", ErrorCode::UnknownKey, 7, "FQ"},
    BadAssignment{"FX=0,fx=1", ErrorCode::DuplicateKey, 6, "FX"},
    BadAssignment{"FX=0, fy = 0 0", ErrorCode::Number, 12, "FY"},
    BadAssignment{"FX=", ErrorCode::Number, 4, "FX"},
    BadAssignment{"FX==0", ErrorCode::Number, 4, "FX"},
    BadAssignment{"ZM=0,ZM=x", ErrorCode::DuplicateKey, 6,
                  "ZM"}, // the key is judged before the value
    BadAssignment{"FX=2", ErrorCode::Range, 4, "FX"},
    BadAssignment{"OBJ=", ErrorCode::Object, 5, "OBJ"},
    BadAssignment{"OBJ=4", ErrorCode::Object, 5, "OBJ"},
    BadAssignment{"OBJ=00", ErrorCode::Object, 5, "OBJ"},
    BadAssignment{"OBJ=cubes", ErrorCode::Object, 5, "OBJ"},
};

TEST(MarcherAssignments, TheFirstFaultWins)
{
    for (const BadAssignment& row : bad_assignments) {
        State state;
        ParameterSet given;
        const auto fault = read_assignments(accelerator, {.bytes = row.text}, state, given);
        ASSERT_TRUE(fault) << row.text;
        EXPECT_EQ(fault->code, row.code) << row.text;
        EXPECT_EQ(fault->column, row.column) << row.text;
        const std::string_view key =
            fault->parameter ? accelerator.parameters[*fault->parameter].key : fault->word;
        EXPECT_EQ(key, row.key) << row.text;
    }
}

TEST(MarcherAssignments, ColumnsCountFromTheLine)
{
    State state;
    ParameterSet given;
    const auto fault = read_assignments(accelerator, {.bytes = " FX=2", .column = 4}, state, given);
    ASSERT_TRUE(fault);
    EXPECT_EQ(fault->column, 8U);
}

TEST(MarcherAssignments, SetsWhatIsNamedAndNothingElse)
{
    State state = initial_state(accelerator);
    ParameterSet given;
    ASSERT_FALSE(read_assignments(accelerator, {.bytes = "obj = Tunnel , ZM=0.5"}, state, given));
    State expected = initial_state(accelerator);
    expected.codes[marcher::OBJ] = 3;
    expected.codes[marcher::ZM] = 1 << 23;
    EXPECT_EQ(state, expected);
    EXPECT_EQ(given.count(), 2U);
    EXPECT_TRUE(given[marcher::OBJ] && given[marcher::ZM]);
}

class Assignments : public test::EveryAccelerator
{
  protected:
    /// The fault of `text`, which is to have one.
    [[nodiscard]] Fault fault_of(const std::string& text) const
    {
        State state = initial_state(accelerator);
        ParameterSet given;
        const auto fault = read_assignments(accelerator, {.bytes = text}, state, given);
        EXPECT_TRUE(fault) << text;
        return fault.value_or(Fault{});
    }
    /// `text` as SET reads it on top of `state`, without a fault.
    [[nodiscard]] State set(State state, const std::string& text) const
    {
        ParameterSet given;
        EXPECT_FALSE(read_assignments(accelerator, {.bytes = text}, state, given)) << text;
        return state;
    }
};
INSTANTIATE_TEST_SUITE_P(Accelerators, Assignments, testing::ValuesIn(accelerators),
                         test::accelerator_name);

TEST_P(Assignments, AFrameOfDefaults)
{
    State state = initial_state(accelerator); // rows keep what they are
    EXPECT_FALSE(read_frame(accelerator, {.bytes = test::default_frame(accelerator)}, state));
    EXPECT_EQ(state, initial_state(accelerator));
}

TEST_P(Assignments, AFrameLeavesTheRowsOfTablesAlone)
{
    auto random = test::seeded_random();
    const State before = test::random_state(accelerator, random);
    State state = before;
    EXPECT_FALSE(read_frame(accelerator, {.bytes = test::default_frame(accelerator)}, state));
    for (std::size_t i = 0; i < table.size(); ++i)
        EXPECT_EQ(state.codes[i], table[i].is_row() ? before.codes[i] : table[i].initial_code)
            << table[i].key;
}

TEST_P(Assignments, WhatIsMissingIsListedAndNothingElse)
{
    for (std::size_t i = 0; i < table.size(); ++i) {
        State state = initial_state(accelerator);
        const std::string text = test::default_frame(accelerator, i);
        const auto fault = read_frame(accelerator, {.bytes = text}, state);
        ASSERT_EQ(fault.has_value(), accelerator.frame[i]) << table[i].key;
        if (!fault)
            continue;
        EXPECT_EQ(fault->code, ErrorCode::MissingKey) << table[i].key;
        EXPECT_EQ(fault->missing, ParameterSet().set(i)) << table[i].key;
    }
    // One pair alone: everything else that a frame needs.
    for (std::size_t i = 0; i < table.size(); ++i) {
        if (table[i].is_tail())
            continue;
        State state = initial_state(accelerator);
        const std::string text = test::default_pair(table[i]);
        const auto fault = read_frame(accelerator, {.bytes = text}, state);
        ASSERT_TRUE(fault) << table[i].key;
        ParameterSet others = accelerator.frame;
        others.set(i, false);
        EXPECT_EQ(fault->missing, others) << table[i].key;
    }
}

TEST_P(Assignments, AKeyStandsOnce)
{
    for (std::size_t i = 0; i < table.size(); ++i) {
        if (table[i].is_tail())
            continue;
        const std::string pair = test::default_pair(table[i]);
        const Fault fault = fault_of(pair + ", " + pair);
        EXPECT_EQ(fault.code, ErrorCode::DuplicateKey) << pair;
        EXPECT_EQ(fault.parameter, i) << pair;
        EXPECT_EQ(fault.column, pair.size() + 3) << pair;
    }
}

/// The nearest number beyond an end of a range that thirty characters hold.
std::string beyond(std::string_view end, bool upper)
{
    const bool away_from_zero = upper != end.starts_with('-');
    const bool has_point = end.find('.') != std::string_view::npos;
    const std::string digits = std::string(has_point || end.size() > 28 ? "" : ".") +
                               std::string(28 - std::min<std::size_t>(end.size(), 28), '0') + "1";
    if (end == "0")
        return (upper ? "0" : "-0") + digits;
    if (away_from_zero)
        return std::string(end) + digits;
    if (has_point) { // its last digit is none of zero
        std::string text(end);
        --text.back();
        return text + "9999";
    }
    return std::to_string(std::stoll(std::string(end)) + (upper ? 1 : -1)) + ".99999999";
}

TEST_P(Assignments, ANumberBeyondItsRangeIsRefused)
{
    for (std::size_t i = 0; i < table.size(); ++i) {
        if (table[i].is_choice() || table[i].is_tail())
            continue;
        const std::string key(table[i].key);
        for (const std::string& value :
             {beyond(table[i].min, false), beyond(table[i].max, true), std::string("1e30")}) {
            const Fault fault = fault_of(" " + key + "=" + value);
            EXPECT_EQ(fault.code, ErrorCode::Range) << key << '=' << value;
            EXPECT_EQ(fault.parameter, i) << key;
            EXPECT_EQ(fault.column, key.size() + 3) << key;
        }
        EXPECT_EQ(fault_of(key + "=1x").code, ErrorCode::Number) << key;
    }
}

TEST_P(Assignments, AWordThatIsNoChoiceIsRefused)
{
    for (std::size_t i = 0; i < table.size(); ++i) {
        if (!table[i].is_choice())
            continue;
        const std::string key(table[i].key);
        for (const std::string& value : {std::to_string(table[i].choices.size()),
                                         std::string(table[i].choices[0]) + "x", std::string()}) {
            const Fault fault = fault_of(key + "=" + value);
            EXPECT_EQ(fault.code, ErrorCode::Object) << key << '=' << value;
            EXPECT_EQ(fault.parameter, i) << key;
            EXPECT_EQ(fault.column, key.size() + 2) << key;
        }
    }
}

TEST_P(Assignments, OnePairChangesOneParameter)
{
    auto random = test::seeded_random();
    const State before = test::random_state(accelerator, random);
    for (std::size_t i = 0; i < table.size(); ++i) {
        if (table[i].is_tail())
            continue;
        State expected = before;
        expected.codes[i] = table[i].initial_code;
        if (table[i].tail_bits > 0)
            expected.codes[i + 1] = 0;
        EXPECT_EQ(set(before, test::default_pair(table[i])), expected) << table[i].key;
    }
}

TEST_P(Assignments, EveryNumberAndChoiceByItsCode)
{
    for (std::size_t i = 0; i < table.size(); ++i) {
        if (table[i].is_tail())
            continue;
        const std::string key = std::string(table[i].key) + "=";
        const State initial = initial_state(accelerator);
        for (std::size_t code = 0; code < table[i].choices.size(); ++code) {
            const auto wanted = static_cast<std::int64_t>(code);
            EXPECT_EQ(set(initial, key + std::to_string(code)).codes[i], wanted) << key;
            EXPECT_EQ(set(initial, key + std::string(table[i].choices[code])).codes[i], wanted)
                << key;
        }
        if (table[i].is_choice())
            continue;
        EXPECT_EQ(set(initial, key + std::string(table[i].min)).codes[i], table[i].min_scaled);
        EXPECT_EQ(set(initial, key + std::string(table[i].max)).codes[i],
                  std::min(table[i].max_scaled, table[i].largest_code));
    }
}

TEST_P(Assignments, KeysOfOtherTablesAreUnknown)
{
    const bool has_rows = std::ranges::any_of(table, &Parameter::is_row);
    EXPECT_EQ(fault_of("QQQ=0").code, ErrorCode::UnknownKey);
    for (const std::string key : {"S0.X", "S99.X", "S1.", "S1X", "S1.X."})
        EXPECT_EQ(fault_of(key + "=0").code, has_rows ? ErrorCode::UnknownKey : ErrorCode::Syntax)
            << key;
    EXPECT_EQ(fault_of("1S.X=0").code, ErrorCode::Syntax);
}

TEST_P(Assignments, AnyStateComesBackFromItsText)
{
    auto random = test::seeded_random();
    for (int i = 0; i < 50; ++i) {
        const State state = test::random_state(accelerator, random);
        ReplyWriter text;
        text.begin(false);
        write_state(text, accelerator, state);
        ASSERT_FALSE(text.overflowed());
        State by_frame(table.size());
        ASSERT_FALSE(read_frame(accelerator, {.bytes = text.text()}, by_frame));
        ASSERT_EQ(by_frame, state) << text.text();
        ASSERT_EQ(set(initial_state(accelerator), std::string(text.text())), state) << text.text();
    }
}

State with(std::initializer_list<std::pair<marcher::Index, std::int64_t>> changes)
{
    State state = initial_state(accelerator);
    for (const auto& [index, code] : changes)
        state.codes[index] = code;
    return state;
}

bool is_camera(std::initializer_list<std::pair<marcher::Index, std::int64_t>> changes)
{
    return basis_is_orthonormal(accelerator, with(changes));
}

TEST(Basis, LengthsMayBeOffByOneHundredth)
{
    using namespace marcher;
    EXPECT_TRUE(is_camera({}));
    EXPECT_TRUE(is_camera({{FZ, 129762}})); // 0.99 * 2^17 = 129761.3
    EXPECT_FALSE(is_camera({{FZ, 129761}}));
    EXPECT_TRUE(is_camera({{RX, -129762}}));
    EXPECT_FALSE(is_camera({{UY, 129761}}));
    // F = (a, a, 0), R = (b, -b, 0), U = z with b = 0.70711; |F| is 1.01 at a = 93608.7 units.
    EXPECT_TRUE(is_camera(
        {{FX, 93608}, {FY, 93608}, {FZ, 0}, {RX, 92682}, {RY, -92682}, {UY, 0}, {UZ, 131071}}));
    EXPECT_FALSE(is_camera(
        {{FX, 93609}, {FY, 93609}, {FZ, 0}, {RX, 92682}, {RY, -92682}, {UY, 0}, {UZ, 131071}}));
}

TEST(Basis, AnglesMayBeOffByOneHundredth)
{
    using namespace marcher;
    // 131071 * z / 2^34 is 0.01 at z = 1310.7 units.
    for (const std::int64_t sign : {1, -1}) {
        EXPECT_TRUE(is_camera({{RZ, sign * 1310}}));
        EXPECT_FALSE(is_camera({{RZ, sign * 1311}}));
        EXPECT_TRUE(is_camera({{UZ, sign * 1310}}));
        EXPECT_FALSE(is_camera({{UZ, sign * 1311}}));
        EXPECT_TRUE(is_camera({{RY, sign * 1310}}));
        EXPECT_FALSE(is_camera({{RY, sign * 1311}}));
    }
}

TEST(Basis, ExtremeCodesDoNotOverflow)
{
    using namespace marcher;
    EXPECT_FALSE(is_camera({{FX, -131072},
                            {FY, -131072},
                            {FZ, -131072},
                            {RX, -131072},
                            {RY, -131072},
                            {RZ, -131072},
                            {UX, -131072},
                            {UY, -131072},
                            {UZ, -131072}}));
}

TEST(Basis, ALeftHandedOneIsNotRefused)
{
    EXPECT_TRUE(is_camera({{marcher::UY, -131071}})); // the contract names lengths and angles only
}

} // namespace
} // namespace raymarch::protocol
