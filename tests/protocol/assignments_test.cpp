// SPDX-License-Identifier: MIT
#include "protocol/assignments.hpp"

#include "protocol/accelerators/marcher.hpp"

#include <gtest/gtest.h>

#include <array>
#include <string>
#include <string_view>

namespace raymarch::protocol
{
namespace
{

constexpr const Accelerator& accelerator = marcher::description;

struct FaultRow
{
    std::string_view text;
    ErrorCode code;
    std::size_t column;
    std::string_view key; ///< of the parameter, or the unknown word
};

constexpr std::array fault_rows = {
    FaultRow{"", ErrorCode::Syntax, 1, ""},
    FaultRow{"FX", ErrorCode::Syntax, 1, ""},
    FaultRow{"=0", ErrorCode::Syntax, 1, ""},
    FaultRow{"FX=0,", ErrorCode::Syntax, 6, ""},
    FaultRow{",FX=0", ErrorCode::Syntax, 1, ""},
    FaultRow{"FX=0,,FY=0", ErrorCode::Syntax, 6, ""},
    FaultRow{"F X=0", ErrorCode::Syntax, 1, ""},
    FaultRow{"F1=0", ErrorCode::Syntax, 1, ""}, // keys are letters
    FaultRow{"FX=0, FQ =1", ErrorCode::UnknownKey, 7, "FQ"},
    FaultRow{"FX=0,fx=1", ErrorCode::DuplicateKey, 6, "FX"},
    FaultRow{"FX=0, fy = 0 0", ErrorCode::Number, 12, "FY"},
    FaultRow{"FX=", ErrorCode::Number, 4, "FX"},
    FaultRow{"FX==0", ErrorCode::Number, 4, "FX"},
    FaultRow{"ZM=0,ZM=x", ErrorCode::DuplicateKey, 6, "ZM"}, // the key is judged before the value
    FaultRow{"FX=2", ErrorCode::Range, 4, "FX"},
    FaultRow{"OBJ=", ErrorCode::Object, 5, "OBJ"},
    FaultRow{"OBJ=4", ErrorCode::Object, 5, "OBJ"},
    FaultRow{"OBJ=00", ErrorCode::Object, 5, "OBJ"},
    FaultRow{"OBJ=cubes", ErrorCode::Object, 5, "OBJ"},
};

TEST(Assignments, TheFirstFaultWins)
{
    for (const FaultRow& row : fault_rows) {
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

TEST(Assignments, ColumnsCountFromTheLine)
{
    State state;
    ParameterSet given;
    const auto fault = read_assignments(accelerator, {.bytes = " FX=2", .column = 4}, state, given);
    ASSERT_TRUE(fault);
    EXPECT_EQ(fault->column, 8U);
}

TEST(Assignments, SetsWhatIsNamedAndNothingElse)
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

std::string whole_frame()
{
    std::string text;
    for (const Parameter& parameter : accelerator.parameters)
        text += (text.empty() ? "" : ",") + std::string(parameter.key) + "=" +
                std::string(parameter.initial);
    return text;
}

TEST(Frame, TheDefaultsAsText)
{
    State state;
    EXPECT_FALSE(read_frame(accelerator, {.bytes = whole_frame()}, state));
    EXPECT_EQ(state, initial_state(accelerator));
}

TEST(Frame, EachParameterCanBeTheMissingOne)
{
    for (std::size_t i = 0; i < accelerator.parameters.size(); ++i) {
        std::string text;
        for (const Parameter& parameter : accelerator.parameters)
            if (&parameter != &accelerator.parameters[i])
                text += (text.empty() ? "" : ",") + std::string(parameter.key) + "=0";
        State state;
        const auto fault = read_frame(accelerator, {.bytes = text}, state);
        ASSERT_TRUE(fault) << accelerator.parameters[i].key;
        EXPECT_EQ(fault->code, ErrorCode::MissingKey);
        EXPECT_EQ(fault->missing, ParameterSet().set(i)) << accelerator.parameters[i].key;
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
