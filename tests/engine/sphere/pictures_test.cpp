// SPDX-License-Identifier: MIT
/// @file
/// Whole pictures and whole frame times of the originals: data/sphere/rows.tsv holds the CRC-32 of
/// every row (made by make_rows.py beside it), data/sphere/core.tsv pixels of the hardware's core.
#include "tests/engine/sphere/drawing.hpp"

#include "base/crc32.hpp"
#include "engine/sphere/rtl_pixel.hpp"
#include "engine/sphere/timeline.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <map>
#include <sstream>
#include <string>

namespace raymarch::engine::sphere
{
namespace
{

/// The rows of a table, without comments.
std::vector<std::vector<std::string>> table(const std::string& name)
{
    std::ifstream file(std::string(RAYMARCH_TEST_DATA "/data/sphere/") + name);
    std::vector<std::vector<std::string>> rows;
    for (std::string line; std::getline(file, line);) {
        if (line.starts_with('#'))
            continue;
        std::istringstream columns(line);
        std::vector<std::string>& row = rows.emplace_back();
        for (std::string column; columns >> column;)
            row.push_back(column);
    }
    return rows;
}

enum Column : std::size_t { Y, APure, ATop, ACorrected, CDefault, CDemo, Columns };

void expect_rows(const Frame& frame, Column column)
{
    const auto expected = table("rows.tsv");
    ASSERT_EQ(expected.size(), source_size.height);
    Drawing drawing = draw_frame(frame);
    for (std::size_t y = 0; y < source_size.height; ++y) {
        const std::span<const std::uint8_t> row = drawing.image.row(y);
        const std::uint32_t crc = crc32({reinterpret_cast<const char*>(row.data()), row.size()});
        ASSERT_EQ(expected[y].size(), Columns);
        ASSERT_EQ(crc, std::stoul(expected[y][column], nullptr, 16)) << "row " << y;
    }
}

TEST(SpherePictures, TheCoresPixelsByThemselves)
{
    expect_rows(frame_a(), APure);
}

TEST(SpherePictures, TheFrameBufferBehindTheWholeHardware)
{
    Frame frame = frame_a();
    frame.design = Design::RtlTimed;
    expect_rows(frame, ATop);
}

TEST(SpherePictures, TheHardwareWithoutItsTwoSlips)
{
    Frame frame = frame_a();
    frame.faults = Faults::Repaired;
    expect_rows(frame, ACorrected);
}

TEST(SpherePictures, ThePrototypesOwnScene)
{
    expect_rows(prototype_scene(), CDefault);
}

TEST(SpherePictures, ThePrototypeWithTheHardwaresScene)
{
    expect_rows(prototype_demo(), CDemo);
}

/// The hardware core's log: values, times and points, the divider being in time.
TEST(SpherePictures, TheCoresLog)
{
    const auto log = table("core.tsv");
    ASSERT_EQ(log.size(), 885U);
    for (const auto& row : log) {
        std::array<int, 8> v{};
        ASSERT_EQ(row.size(), v.size());
        std::ranges::transform(row, v.begin(), [](const std::string& s) { return std::stoi(s); });
        const auto [enable, ready, x, y, value, near_x, near_y, near_z] = v;
        const RtlPixel pixel = rtl_pixel(frame_a(), x, y);
        const testing::ScopedTrace trace(__FILE__, __LINE__, row[0]);
        EXPECT_EQ(row_of(pixel.outcome).ready, ready - enable);
        EXPECT_EQ(pixel.value, value);
        EXPECT_EQ(pixel.point, (Point{near_x, near_y, near_z}));
        EXPECT_TRUE(!row_of(pixel.outcome).lit ||
                    divider_in_time(static_cast<std::uint64_t>(enable), row_of(pixel.outcome)));
    }
}

std::map<std::uint32_t, int> pixels_by_period(const Drawing& drawing)
{
    std::map<std::uint32_t, int> counts;
    for (const PixelCost& cost : drawing.costs)
        ++counts[cost.steps];
    return counts;
}

TEST(SpherePictures, FrameATakesTheEdgesOfTheSimulation)
{
    for (const Design design : {Design::Rtl, Design::RtlTop, Design::RtlTimed}) {
        Frame frame = frame_a();
        frame.design = design;
        const Drawing drawing = draw_frame(frame);
        EXPECT_EQ(pixels_by_period(drawing),
                  (std::map<std::uint32_t, int>{{1008, 281'018}, {4608, 11'350}, {7012, 14'832}}));
        EXPECT_EQ(frame_cycles(frame, {}, drawing.costs, 1), 439'568'928U);
    }
}

TEST(SpherePictures, RepairedFrameATurnsItsLitSideToTheLight)
{
    Frame frame = frame_a();
    frame.faults = Faults::Repaired;
    const auto counts = pixels_by_period(draw_frame(frame));
    EXPECT_EQ(counts.at(1008), 281'018);
    EXPECT_EQ((counts.contains(4608) ? counts.at(4608) : 0) + counts.at(6108), 18'184);
    EXPECT_EQ(counts.at(7012), 7'998);
}

} // namespace
} // namespace raymarch::engine::sphere
