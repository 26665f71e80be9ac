// SPDX-License-Identifier: MIT
/// @file
/// The Mandelbulb's kernels against its reference, where their shortcuts begin and end.
#include "identity.hpp"
#include "protocol/accelerators/mandelbulb.hpp"
#include "protocol/assignments.hpp"
#include "protocol/registers.hpp"
#include "tests/fakes/random.hpp"

#include <array>
#include <cmath>
#include <random>
#include <string>

namespace raymarch::engine::identity
{
namespace
{

namespace table = protocol::mandelbulb;
using Code = std::int64_t;
using protocol::State;
using test::pick;

const Model& model = model_of(table::description);

State state_of(std::string_view settings)
{
    State state = protocol::initial_state(table::description);
    protocol::ParameterSet given;
    EXPECT_FALSE(!settings.empty() &&
                 protocol::read_assignments(table::description, {.bytes = settings}, state, given))
        << settings;
    return state;
}

void expect_drawn_the_same(const State& state, const Region& region)
{
    identity::expect_identity(model, protocol::pack(table::description, state), region);
}

class MandelbulbPreset : public testing::TestWithParam<protocol::Preset>
{};

TEST_P(MandelbulbPreset, IsDrawnTheSame)
{
    expect_drawn_the_same(state_of(GetParam().settings), whole({7, 4}));
}

TEST_P(MandelbulbPreset, IsDrawnTheSameWithAllBits)
{
    State state = state_of(GetParam().settings);
    state.codes[table::N] = 57;
    state.codes[table::COLOUR] ^= 1;
    expect_drawn_the_same(state, whole({5, 3}));
    state.codes[table::N] = 64;
    state.codes[table::FORM] ^= 1;
    expect_drawn_the_same(state, whole({3, 2}));
}

INSTANTIATE_TEST_SUITE_P(Mandelbulb, MandelbulbPreset, testing::ValuesIn(table::presets),
                         [](const auto& of) { return std::string(of.param.name); });

/// Numbers of the pipeline and the march anywhere in their ranges.
void any_numbers(std::mt19937_64& random, State& state)
{
    for (std::size_t i = table::N; i < table::parameters.size(); ++i) {
        const protocol::Parameter& row = table::parameters[i];
        const Code last =
            row.choices.empty() ? row.max_scaled : static_cast<Code>(row.choices.size()) - 1;
        state.codes[i] = pick<Code>(random, row.choices.empty() ? row.min_scaled : 0, last);
    }
    if (pick(random, 0, 1) == 0)
        state.codes[table::SCALE] = 0;
    state.codes[table::I] = pick<Code>(random, 1, pick(random, 0, 3) == 0 ? 64 : 12);
}

void any_position(std::mt19937_64& random, State& state, double reach)
{
    for (const auto axis : {table::X, table::Y, table::Z}) {
        const double at = std::uniform_real_distribution(-reach, reach)(random);
        state.codes[axis] = static_cast<Code>(std::ldexp(at, 32));
        state.codes[axis + 1] = pick<Code>(random, 0, 0xFFFF'FFFF);
    }
}

constexpr std::array<std::size_t, 9> basis = {table::FX, table::FY, table::FZ, table::RX, table::RY,
                                              table::RZ, table::UX, table::UY, table::UZ};

/// Neither of length 1 nor at right angles.
void any_basis(std::mt19937_64& random, State& state)
{
    for (const std::size_t i : basis)
        state.codes[i] = pick<Code>(random, -(Code{1} << 57), Code{1} << 57);
}

TEST(MandelbulbIdentity, CamerasAnywhereWithAnyNumbers)
{
    std::mt19937_64 random = test::seeded_random();
    for (int i = 0; i < 60; ++i) {
        State state = state_of("");
        any_numbers(random, state);
        any_position(random, state, i % 3 == 0 ? 4.0 : i % 3 == 1 ? 1.5 : 0.6);
        any_basis(random, state);
        expect_drawn_the_same(state, whole({5, 4}));
    }
}

TEST(MandelbulbIdentity, CamerasOfThePresetsMovedALittleWithAnyNumbers)
{
    std::mt19937_64 random = test::seeded_random();
    for (int i = 0; i < 60; ++i) {
        const auto at = pick<std::size_t>(random, 0, table::presets.size() - 1);
        State state = state_of(table::presets[at].settings);
        const Code power = state.codes[table::POWER];
        any_numbers(random, state);
        state.codes[table::POWER] = power;
        for (const auto axis : {table::X_TAIL, table::Y_TAIL, table::Z_TAIL})
            state.codes[axis] = pick<Code>(random, 0, 0xFFFF'FFFF);
        expect_drawn_the_same(state, whole({5, 4}));
    }
}

TEST(MandelbulbIdentity, EveryNumberOfStepsAndBits)
{
    for (int n = 8; n <= 64; ++n) {
        State state = state_of("X=1.9,Y=-1.5,Z=0.9,FX=-0.7356829,FY=0.5808203,FZ=-0.3484814,"
                               "RX=0.6196443,RY=0.7848828,UX=-0.273517,UY=0.2159345,UZ=0.9373157");
        state.codes[table::N] = n;
        expect_drawn_the_same(state, whole({4, 3}));
        state.codes[table::K] = n;
        state.codes[table::FORM] = n % 2;
        expect_drawn_the_same(state, whole({4, 3}));
    }
}

TEST(MandelbulbIdentity, CamerasOnTheAxesAndAtTheMiddle)
{
    for (const char* const settings : {"X=0,Y=0,Z=0",
                                       "X=0,Y=0,Z=2.5,FX=0,FY=0,FZ=-1,RX=1,UX=0,UY=1,UZ=0",
                                       "X=2.5,Y=0,FX=-1,FY=0,RX=0,RY=1",
                                       "X=-4,Y=4,Z=-4",
                                       "X=4,Y=4,Z=4",
                                       "Y=-1.5",
                                       "Y=-1",
                                       "FY=0",
                                       "FY=0,RX=0,UZ=0",
                                       "RX=0",
                                       "UZ=0",
                                       "Y=-2.5,FY=-1",
                                       "STEPS=1",
                                       "STEPS=2",
                                       "I=1",
                                       "I=2",
                                       "Y=-1.2,B=16,I=64",
                                       "Y=-1.2,B=16,I=64,DERIVATIVE=q33_32",
                                       "SCALE=60",
                                       "SCALE=3,Y=-1.2"})
        for (const Code n : {8, 32, 57}) {
            State state = state_of(settings);
            state.codes[table::N] = n;
            expect_drawn_the_same(state, whole({8, 6}));
        }
}

TEST(MandelbulbIdentity, WordsOfNoFrame)
{
    std::mt19937_64 random = test::seeded_random();
    for (int i = 0; i < 20; ++i) {
        protocol::Words words = protocol::pack(table::description, state_of(""));
        for (std::uint32_t& word : words)
            word = static_cast<std::uint32_t>(random());
        identity::expect_identity(model, words, whole({3, 3}));
    }
}

TEST(MandelbulbIdentity, PartsOfThePicture)
{
    const State state = state_of("N=20,COLOUR=index");
    constexpr PictureSize size{67, 41};
    for (const Region& region :
         {Region{.size = size, .width = 67, .height = 16},
          Region{.size = size, .x = 5, .y = 3, .width = 31, .height = 30, .step = 3},
          Region{.size = size, .x = 66, .y = 40, .width = 1, .height = 1},
          Region{.size = size, .x = 9, .y = 9, .width = 0, .height = 9}})
        expect_drawn_the_same(state, region);
    for (const PictureSize odd : {PictureSize{1, 1}, PictureSize{1, 9}, PictureSize{23, 1}})
        expect_drawn_the_same(state, whole(odd));
}

} // namespace
} // namespace raymarch::engine::identity
