// SPDX-License-Identifier: MIT
/// @file
/// The sphere tracer as a host meets it: settings to words, words to frames and pictures.
#include "base/crc32.hpp"
#include "engine/draw.hpp"
#include "engine/models.hpp"
#include "engine/sphere/sphere.hpp"
#include "protocol/assignments.hpp"
#include "protocol/registers.hpp"
#include "tests/engine/sphere/drawing.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <string_view>

namespace raymarch::engine::sphere
{
namespace
{

namespace table = protocol::sphere;

protocol::Words words_of(std::string_view settings)
{
    protocol::State state = protocol::initial_state(table::description);
    if (settings.empty())
        return protocol::pack(table::description, state);
    protocol::ParameterSet given;
    EXPECT_FALSE(protocol::read_assignments(table::description, {.bytes = settings}, state, given))
        << settings;
    return protocol::pack(table::description, state);
}

const protocol::Preset& preset(std::string_view name)
{
    const auto found = std::ranges::find(table::presets, name, &protocol::Preset::name);
    EXPECT_NE(found, table::presets.end()) << name;
    return *found;
}

/// A picture by Model, at the source's size.
Image picture(std::string_view settings)
{
    Image image(source_size);
    draw(model_of(table::description), words_of(settings), image, 1);
    return image;
}

void expect_same_scene(const Frame& a, const Frame& b)
{
    EXPECT_EQ(a.design, b.design);
    EXPECT_EQ(a.faults, b.faults);
    EXPECT_EQ(a.tint, b.tint);
    EXPECT_EQ(a.eye, b.eye);
    EXPECT_EQ(a.screen, b.screen);
    EXPECT_EQ(a.calibration, b.calibration);
    EXPECT_EQ(a.derounder, b.derounder);
    EXPECT_EQ(a.shadow, b.shadow);
    EXPECT_EQ(a.ball_count, b.ball_count);
    EXPECT_EQ(a.light_count, b.light_count);
    for (std::size_t i = 0; i < a.ball_count; ++i) {
        EXPECT_EQ(a.balls[i].centre, b.balls[i].centre) << i;
        EXPECT_EQ(a.balls[i].radius, b.balls[i].radius) << i;
    }
    for (std::size_t i = 0; i < a.light_count; ++i) {
        EXPECT_EQ(a.lights[i].position, b.lights[i].position) << i;
        EXPECT_EQ(a.lights[i].strength, b.lights[i].strength) << i;
    }
}

TEST(SphereWords, TheDefaultsAreTheHardwaresPowerUp)
{
    expect_same_scene(latch(words_of("")), Frame{});
}

TEST(SphereWords, PresetsAreTheSourcesScenes)
{
    expect_same_scene(latch(words_of(preset("core").settings)), frame_a());
    expect_same_scene(latch(words_of(preset("prototype").settings)), prototype_scene());
    expect_same_scene(latch(words_of(preset("prototype_demo").settings)), prototype_demo());
}

TEST(SphereWords, EveryValueArrives)
{
    const Frame frame = latch(words_of(
        "MODEL=rtl_timed,FAULTS=corrected,TINT=grey,N=3,M=8,CUTOFF=255,D=65535,K=65534,EX=-65536,"
        "EY=65535,EZ=-1,F=-2,S3.X=-3,S3.Y=4,S3.Z=-5,S3.R=65535,L8.X=6,L8.Y=-7,L8.Z=8,"
        "L8.S=2147483647"));
    EXPECT_EQ(frame.design, Design::RtlTimed);
    EXPECT_EQ(frame.faults, Faults::Corrected);
    EXPECT_EQ(frame.tint, Tint::Grey);
    EXPECT_EQ(frame.ball_count, 3U);
    EXPECT_EQ(frame.light_count, 8U);
    EXPECT_EQ(frame.shadow, 255);
    EXPECT_EQ(frame.derounder, 65'535);
    EXPECT_EQ(frame.calibration, 65'534);
    EXPECT_EQ(frame.eye, (Point{-65'536, 65'535, -1}));
    EXPECT_EQ(frame.screen, -2);
    EXPECT_EQ(frame.balls[2].centre, (Point{-3, 4, -5}));
    EXPECT_EQ(frame.balls[2].radius, 65'535);
    EXPECT_EQ(frame.lights[7].position, (Point{6, -7, 8}));
    EXPECT_EQ(frame.lights[7].strength, 2'147'483'647);
}

TEST(SphereWords, WordsThatNoHostSetsAreDefinedToo)
{
    protocol::Words words(table::description.word_count);
    std::ranges::fill(words, ~std::uint32_t{0});
    const Frame frame = latch(words);
    EXPECT_EQ(frame.faults, Faults::Corrected);
    EXPECT_EQ(frame.light_count, max_lights);
    EXPECT_EQ(frame.eye, (Point{-1, -1, -1}));
}

std::uint32_t crc_of(const Image& image)
{
    return crc32({reinterpret_cast<const char*>(image.rgb.data()), image.rgb.size()});
}

TEST(SphereWords, PicturesByWordsAreThoseByFrames)
{
    Frame timed = frame_a();
    timed.design = Design::RtlTimed;
    EXPECT_EQ(picture(preset("board").settings).rgb, draw_frame(timed).image.rgb);
    EXPECT_EQ(picture(preset("prototype").settings).rgb, draw_frame(prototype_scene()).image.rgb);
}

TEST(SphereWords, CyclesAreSharedOutAmongUnits)
{
    const protocol::Words words = words_of("S1.R=0");
    const std::vector<PixelCost> costs(3, {1008, 1});
    const auto cycles = [&](unsigned units) {
        return model_of(table::description).latch(words)->cycles({}, costs, units);
    };
    EXPECT_EQ(cycles(1), 3'024U);
    EXPECT_EQ(cycles(5), 605U);
}

TEST(SphereWords, EveryPresetShowsSomethingOfItsOwn)
{
    constexpr std::size_t step = 20; // rows
    std::vector<std::uint32_t> seen;
    for (const protocol::Preset& each : table::presets) {
        const Frame frame = latch(words_of(each.settings));
        Image image({source_size.width, source_size.height / step});
        std::vector<PixelCost> costs(source_size.width);
        for (std::uint16_t y = 0; y < image.size.height; ++y)
            draw_row(frame, {source_size, static_cast<std::uint16_t>(y * step)}, image.row(y),
                     costs);
        const auto [darkest, brightest] = std::ranges::minmax(image.rgb);
        EXPECT_GT(brightest - darkest, 30) << each.name;
        if (frame.design != Design::RtlTimed) // differs by a pixel's shift
            seen.push_back(crc_of(image));
    }
    std::ranges::sort(seen);
    EXPECT_EQ(std::ranges::adjacent_find(seen), seen.end());
}

TEST(SphereWords, TheSameBytesForAnyNumberOfThreads)
{
    const protocol::Words words = words_of(preset("board").settings);
    Image one(source_size);
    Image three(source_size);
    EXPECT_EQ(draw(model_of(table::description), words, one, 1),
              draw(model_of(table::description), words, three, 3));
    EXPECT_EQ(one.rgb, three.rgb);
}

} // namespace
} // namespace raymarch::engine::sphere
