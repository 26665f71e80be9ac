// SPDX-License-Identifier: MIT
/// @file
/// From settings through words to frames and pictures.
#include "engine/draw.hpp"
#include "engine/models.hpp"
#include "engine/whitted/frame.hpp"
#include "engine/whitted/whitted.hpp"
#include "protocol/assignments.hpp"
#include "protocol/registers.hpp"
#include "tests/engine/whitted/report.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace raymarch::engine::whitted
{
namespace
{

namespace table = protocol::whitted;
using test::at;

const Model& model = model_of(table::description);

protocol::Words words_of(std::string_view settings)
{
    protocol::State state = protocol::initial_state(table::description);
    protocol::ParameterSet given;
    if (!settings.empty()) {
        EXPECT_FALSE(
            protocol::read_assignments(table::description, {.bytes = settings}, state, given))
            << settings;
    }
    return protocol::pack(table::description, state);
}

Frame frame_of(std::string_view settings)
{
    return latch(words_of(settings));
}

std::string_view preset(std::string_view name)
{
    const auto* const row = std::ranges::find(table::presets, name, &protocol::Preset::name);
    EXPECT_NE(row, table::presets.end()) << name;
    return row->settings;
}

void expect_same(const Sphere& a, const Sphere& b)
{
    EXPECT_EQ(a.centre, b.centre);
    EXPECT_EQ(a.colour, b.colour);
    EXPECT_EQ(a.reflect, b.reflect);
    EXPECT_EQ(a.radius, b.radius);
    EXPECT_EQ(a.squared_radius, b.squared_radius);
    EXPECT_EQ(a.inverse_radius, b.inverse_radius);
}

void expect_same(const Plane& a, const Plane& b)
{
    EXPECT_EQ(a.normal, b.normal);
    EXPECT_EQ(a.offset, b.offset);
    EXPECT_EQ(a.colour, b.colour);
    EXPECT_EQ(a.checker, b.checker);
    EXPECT_EQ(a.bounded, b.bounded);
    EXPECT_EQ(a.reflect, b.reflect);
    EXPECT_EQ(a.limits, b.limits);
}

TEST(WhittedWords, ThePresetsOfTheReportAreItsScenes)
{
    for (const std::string name : {"image1", "image2"}) {
        const Frame expected = test::report_frame(Profile::Repaired, name);
        const Frame frame = frame_of(preset(name));
        EXPECT_EQ(frame.defects, expected.defects);
        EXPECT_EQ(frame.eye, expected.eye);
        EXPECT_EQ(frame.light, expected.light);
        EXPECT_EQ(frame.screen, expected.screen);
        ASSERT_EQ(frame.last, expected.last) << name;
        for (std::size_t i = 0; i <= frame.last; ++i)
            expect_same(frame.spheres.at(i), expected.spheres.at(i));
        for (std::size_t i = 0; i < plane_count; ++i)
            expect_same(frame.planes.at(i), expected.planes.at(i));
        EXPECT_FALSE(frame.planes_drawn);
        EXPECT_EQ(frame.reflections, 3);
        EXPECT_EQ(frame.anti_aliasing, AntiAliasing::Eight);
    }
    EXPECT_TRUE(frame_of(preset("image2_room")).planes_drawn);
}

TEST(WhittedWords, EachSettingArrives)
{
    const Frame frame = frame_of(
        "PROFILE=measured,EX=1,EY=-2.5,EZ=3,LX=-4,LY=5,LZ=6,LR=2047,S=0.0625,REFLECTIONS=1,AA=4x,"
        "PLANES=off,N=14,S14.X=-1024,S14.RADIUS=100,S14.B=31,S14.REFLECT=1,P4.C=-0.5,P4.D=-3,"
        "P4.BLUE=7,P4.CHECKER=15,P4.BOUNDED=on,P4.REFLECT=0.25,P4.XL=4095,P4.YL=2,P4.ZL=3");
    EXPECT_EQ(frame.defects, Defects(Profile::Measured));
    EXPECT_EQ(test::raw(frame.eye), (std::array{4096, -10240, 12288}));
    EXPECT_EQ(test::raw(frame.light), test::raw(at(-4, 5, 6)));
    EXPECT_EQ(frame.screen.raw(), 256);
    EXPECT_EQ(frame.reflections, 1);
    EXPECT_EQ(frame.anti_aliasing, AntiAliasing::Four);
    EXPECT_FALSE(frame.planes_drawn);
    ASSERT_EQ(frame.last, 14);
    expect_same(frame.spheres[14], make_light(at(-4, 5, 6), 2047));
    expect_same(frame.spheres[13], make_sphere(at(-1024, 18, -10), 100, {31, 8, 31}, 4095));
    Plane plane{.normal = {at(1, 0, 0).x, {}, Word::from_raw(-2048)}, .offset = at(-3, 0, 0).x};
    plane.colour = {0, 0, 7 * 32};
    plane.checker = 15;
    plane.bounded = true;
    plane.reflect = 1024;
    plane.limits = {4095, 2, 3};
    expect_same(frame.planes[3], plane);
}

TEST(WhittedWords, WhatNoFrameSetsCountsAsTheNearest)
{
    protocol::Words words(table::description.word_count);
    Frame frame = latch(words); // all bits 0
    EXPECT_EQ(frame.last, 1);
    expect_same(frame.spheres[0], make_sphere({}, 1, {0, 0, 0}, 0));
    expect_same(frame.spheres[1], make_light({}, 1));
    std::ranges::fill(words, 0xFFFF'FFFF);
    frame = latch(words);
    EXPECT_EQ(frame.last, 14);
    EXPECT_EQ(frame.anti_aliasing, AntiAliasing::Eight);
}

TEST(WhittedWords, AnyWordsDrawSomethingWithoutFault)
{
    // The sanitizers' turn: numbers that wrap everywhere.
    std::mt19937_64 random(7);
    for (int i = 0; i < 20; ++i) {
        protocol::Words words(table::description.word_count);
        std::ranges::generate(words, [&] { return static_cast<std::uint32_t>(random()); });
        Image image({9, 7});
        const std::vector<PixelCost> costs = draw(model, words, image, 1);
        EXPECT_GT(frame_cycles(model, words, image.size, 0, costs), 9U * 7U * 17U);
    }
}

TEST(WhittedWords, EveryPresetShowsSomething)
{
    std::vector<std::string_view> names;
    for (const protocol::Preset& row : table::presets) {
        // A few rows of the middle of the picture.
        const Frame frame = frame_of(row.settings);
        Image image({128, 96});
        std::vector<PixelCost> costs(image.size.width);
        for (std::uint16_t y = 0; y < image.size.height; y += 24)
            draw_row(frame, {image.size, y}, image.row(y), costs);
        const auto [darkest, brightest] = std::ranges::minmax(image.rgb);
        EXPECT_GT(brightest - darkest, 60) << row.name;
        EXPECT_FALSE(row.summary.empty());
        EXPECT_EQ(std::ranges::count(names, row.name), 0) << row.name;
        names.push_back(row.name);
    }
}

TEST(WhittedWords, RowsFrameAndCyclesOfTheBestCase)
{
    const protocol::Words words = words_of("PROFILE=measured,LR=3,REFLECTIONS=0,PLANES=off,AA=off");
    Image image({320, 240});
    const std::vector<PixelCost> costs = draw(model, words, image, 2);
    EXPECT_EQ(frame_cycles(model, words, image.size, 0, costs), 4'678'168U);
    // The smaller picture is the middle of the larger one.
    Image larger({512, 480});
    std::vector<PixelCost> row(512);
    draw_row(latch(words), {larger.size, 240}, larger.row(240), row);
    EXPECT_TRUE(std::ranges::equal(larger.row(240).subspan(3 * 96, 3 * 320), image.row(120)));
}

} // namespace
} // namespace raymarch::engine::whitted
