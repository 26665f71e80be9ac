// SPDX-License-Identifier: MIT
/// @file
/// The words: what they say, what they say out of range, and the views that the table offers.
#include "engine/mandelbulb/frame.hpp"

#include "engine/draw.hpp"
#include "engine/mandelbulb/distance.hpp"
#include "engine/models.hpp"
#include "protocol/assignments.hpp"
#include "protocol/registers.hpp"
#include "tests/engine/mandelbulb/views.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <string>

namespace raymarch::engine::mandelbulb
{
namespace
{

namespace table = protocol::mandelbulb;

protocol::State state_of(std::string_view settings)
{
    protocol::State state = protocol::initial_state(table::description);
    protocol::ParameterSet given;
    if (!settings.empty()) {
        EXPECT_FALSE(
            protocol::read_assignments(table::description, {.bytes = settings}, state, given))
            << settings;
    }
    return state;
}

Frame frame_of(std::string_view settings)
{
    return latch(protocol::pack(table::description, state_of(settings)));
}

const Model& model()
{
    return model_of(table::description);
}

TEST(MandelbulbWords, TheDefaults)
{
    constexpr std::int64_t unit = std::int64_t{1} << 57;
    Frame expected{};
    expected.position = {Int128(0), -(Int128(5) << 63), Int128(0)};
    expected.forward = {0, unit, 0};
    expected.right = {unit, 0, 0};
    expected.up = {0, 0, unit};
    EXPECT_EQ(frame_of(""), expected);
}

TEST(MandelbulbWords, EveryParameterArrives)
{
    const Frame frame = frame_of("X=-3.25,Y=4,Z=-4,FX=-1,RY=0.5,UZ=-0.25,N=57,K=20,POWER=16,I=64,"
                                 "B=16,STEPS=1,FORM=q8_64,DERIVATIVE=q33_32,SCALE=60,"
                                 "COLOUR=index,ASPECT=square");
    EXPECT_TRUE(frame.position.x == -(Int128(13) << 62));
    EXPECT_TRUE(frame.position.y == Int128(4) << 64);
    EXPECT_TRUE(frame.position.z == -(Int128(4) << 64));
    EXPECT_EQ(frame.forward.x, -(std::int64_t{1} << 57));
    EXPECT_EQ(frame.right.y, std::int64_t{1} << 56);
    EXPECT_EQ(frame.up.z, -(std::int64_t{1} << 55));
    EXPECT_EQ(frame.arithmetic, (Arithmetic{.steps = 57,
                                            .kept_bits = 20,
                                            .power = 16,
                                            .iterations = 64,
                                            .derivative = DerivativeForm::Saturating,
                                            .scale = 60}));
    EXPECT_EQ(frame.epsilon_shift, 16);
    EXPECT_EQ(frame.max_evaluations, 1);
    EXPECT_EQ(frame.form, Form::Q8_64);
    EXPECT_EQ(frame.colour, ColourMode::Index);
    EXPECT_EQ(frame.aspect, Aspect::Square);
}

TEST(MandelbulbWords, APositionIsInThreeWords)
{
    // -2^-64: all ones; -1 + 2^-32: the integer and the last bit above the tail.
    const protocol::Words words =
        protocol::pack(table::description, state_of("X=-0.00000000000000000005,Y=1"));
    EXPECT_EQ(words[2], 0x0000'01FFU);
    EXPECT_EQ(words[3], 0xFFFF'FFFFU);
    EXPECT_EQ(words[4], 0xFFFF'FFFFU);
    EXPECT_EQ(words[5], 0U);
}

TEST(MandelbulbWords, TheMultiplierByItself)
{
    EXPECT_EQ(frame_of("N=9").arithmetic.kept_bits, 17);
    EXPECT_EQ(frame_of("N=57").arithmetic.kept_bits, 61);
    EXPECT_EQ(frame_of("N=64").arithmetic.kept_bits, 64);
    EXPECT_EQ(frame_of("N=64,K=3").arithmetic.kept_bits, 8);
}

TEST(MandelbulbWords, OtherWordsCountAsTheNearestEnd)
{
    const auto latch_all = [](std::uint32_t word) {
        return latch(std::vector<std::uint32_t>(table::description.word_count, word));
    };
    const Frame zeros = latch_all(0);
    EXPECT_EQ(zeros.arithmetic.steps, 8);
    EXPECT_EQ(zeros.arithmetic.kept_bits, 17);
    EXPECT_EQ(zeros.arithmetic.power, 2);
    EXPECT_EQ(zeros.arithmetic.iterations, 1);
    EXPECT_EQ(zeros.epsilon_shift, 4);
    EXPECT_EQ(zeros.max_evaluations, 1);
    const Frame ones = latch_all(~std::uint32_t{0});
    EXPECT_EQ(ones.arithmetic.steps, 64);
    EXPECT_EQ(ones.arithmetic.kept_bits, 64);
    EXPECT_EQ(ones.arithmetic.power, 16);
    EXPECT_EQ(ones.arithmetic.iterations, 64);
    EXPECT_EQ(ones.arithmetic.scale, 60);
    EXPECT_EQ(ones.epsilon_shift, 16);
    EXPECT_EQ(ones.max_evaluations, 200);
    EXPECT_TRUE(ones.position.x == -1);
    const Frame far = latch_all(0x7F7F'7F7F);
    EXPECT_TRUE(far.position.x == Int128(4) << 64);
    EXPECT_TRUE(latch_all(0x8080'8080).position.z == -(Int128(4) << 64));
}

TEST(MandelbulbWords, AnyWordsDraw)
{
    // Sums that left their range, or shifts, would be caught by the sanitizers.
    std::uint32_t random = 3;
    for (int i = 0; i < 60; ++i) {
        std::vector<std::uint32_t> words(table::description.word_count);
        for (std::uint32_t& word : words)
            word = random = random * 1'664'525 + 1'013'904'223;
        words[1] &= 0xFF07'FFFF; // at most 7 evaluations
        Image image({3, 2});
        const auto costs = draw(model(), words, image, 1);
        EXPECT_GT(frame_cycles(model(), words, image.size, 0, costs), 0U);
    }
}

TEST(MandelbulbWords, ThePresetsOfTheVectorsAreTheirViews)
{
    for (const View& view : read_views()) {
        std::string name = view.name;
        std::ranges::transform(name, name.begin(), [](char c) { return c == 'A' ? 'a' : c; });
        const auto preset = std::ranges::find(table::presets, name, &protocol::Preset::name);
        ASSERT_NE(preset, table::presets.end()) << name;
        const Frame frame = frame_of(preset->settings);
        EXPECT_EQ(frame.position, view.frame.position) << name;
        EXPECT_EQ(frame.forward, view.frame.forward) << name;
        EXPECT_EQ(frame.right, view.frame.right) << name;
        EXPECT_EQ(frame.up, view.frame.up) << name;
    }
}

TEST(MandelbulbPresets, StandInFreeSpaceAndShowSomething)
{
    for (const protocol::Preset& preset : table::presets) {
        SCOPED_TRACE(std::string(preset.name));
        const protocol::State state = state_of(preset.settings);
        const Frame frame = latch(protocol::pack(table::description, state));
        const auto length = [](const Direction& v) {
            const auto part = [](std::int64_t a) {
                return std::ldexp(static_cast<double>(a), -57);
            };
            return std::hypot(part(v.x), part(v.y), part(v.z));
        };
        EXPECT_NEAR(length(frame.forward), 1, 1e-14);
        EXPECT_NEAR(length(frame.right), 1, 1e-14);
        EXPECT_NEAR(length(frame.up), 1, 1e-14);
        if (frame.form == Form::Q8_57) {
            using Narrow = Q57<Int128>;
            const Point<Narrow> eye = position_in<Narrow>(frame.position);
            EXPECT_GT(estimate<Narrow>(eye, frame.arithmetic).distance, 0);
        }
        Image image({8, 5});
        draw(model(), protocol::pack(table::description, state), image, 0);
        const auto [darkest, brightest] = std::ranges::minmax(image.rgb);
        EXPECT_GT(brightest - darkest, 30);
    }
}

} // namespace
} // namespace raymarch::engine::mandelbulb
