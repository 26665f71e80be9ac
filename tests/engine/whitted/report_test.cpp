// SPDX-License-Identifier: MIT
/// @file
/// The profile `measured` against the machine: rays and clock cycles of the 17 frames of the report
/// (source 004, Fig. 12), and three whole pictures.
#include "base/crc32.hpp"
#include "engine/whitted/pixel.hpp"
#include "engine/whitted/whitted.hpp"
#include "tests/engine/whitted/report.hpp"

#include <gtest/gtest.h>

#include <thread>

namespace raymarch::engine::whitted
{
namespace
{

using test::number;

struct Row
{
    Frame frame;
    PictureSize size;
    FrameCost cost;
    std::string why;
};

Row parse(const test::Columns& columns)
{
    const auto value = [&](std::size_t i) {
        return static_cast<std::uint16_t>(number(columns.at(i)));
    };
    Row row{.frame = test::report_frame(Profile::Measured, columns.at(0)),
            .size = {value(4), value(5)},
            .cost = {.cycles = static_cast<std::uint64_t>(number(columns.at(7))),
                     .rays = static_cast<std::uint64_t>(number(columns.at(6)))},
            .why = columns.at(0) + ": " + columns.at(8)};
    row.frame.planes_drawn = value(1) != 0;
    row.frame.anti_aliasing = value(2) == 8 ? AntiAliasing::Eight : AntiAliasing::Off;
    row.frame.reflections = static_cast<std::uint8_t>(value(3));
    return row;
}

FrameCost cost_of(const Frame& frame, PictureSize size)
{
    Image image(size);
    std::vector<PixelCost> costs(std::size_t{size.width} * size.height);
    const auto work = [&](std::uint16_t first) {
        for (std::uint16_t y = first; y < size.height; y += 2)
            draw_row(frame, {size, y}, image.row(y),
                     std::span(costs).subspan(std::size_t{y} * size.width, size.width));
    };
    {
        const std::jthread other(work, std::uint16_t{1});
        work(0);
    }
    return frame_cost(frame, size, costs);
}

/// All rows of the table, or those that any build draws in a second.
std::vector<test::Columns> report_rows()
{
    std::vector<test::Columns> rows = test::read_table("performance.tsv");
    if (!test::optimised)
        std::erase_if(rows, [](const auto& row) { return number(row.at(6)) > 330'000; });
    return rows;
}

/// A row's scene and settings, as in `image1_planes_8x_reflections3_512x480`.
std::string row_name(const testing::TestParamInfo<test::Columns>& row)
{
    const test::Columns& columns = row.param;
    return columns.at(0) + (number(columns.at(1)) != 0 ? "_planes" : "") +
           (number(columns.at(2)) == 8 ? "_8x" : "") + "_reflections" + columns.at(3) + "_" +
           columns.at(4) + "x" + columns.at(5);
}

class Report : public testing::TestWithParam<test::Columns>
{};

TEST_P(Report, RaysAndCyclesAreThoseOfTheTable)
{
    const Row row = parse(GetParam());
    const FrameCost cost = cost_of(row.frame, row.size);
    EXPECT_EQ(cost.rays, row.cost.rays) << row.why;
    EXPECT_EQ(cost.cycles, row.cost.cycles) << row.why;
}

INSTANTIATE_TEST_SUITE_P(Whitted, Report, testing::ValuesIn(report_rows()), row_name);

/// As the reference pictures are written: the converter's 10 bits as 8, rounded.
std::string reference_bytes(const FrameWord& word)
{
    std::string bytes;
    for (const std::uint8_t channel : word.channels) {
        const int converter = channel << 5 | (word.light ? 31 : 0);
        bytes += static_cast<char>((2 * converter * 255 + 1023) / (2 * 1023));
    }
    return bytes;
}

class Pictures : public testing::TestWithParam<std::string>
{};

TEST_P(Pictures, AreThoseOfTheMachine)
{
    const std::string& name = GetParam();
    Frame frame = test::report_frame(Profile::Measured, "image1");
    if (name == "image1_planes_reflections") {
        frame.planes_drawn = true;
        frame.reflections = 3;
    }
    const PictureSize size = name == "best_case" ? PictureSize{320, 240} : PictureSize{512, 480};
    const unsigned step = test::optimised ? 1 : 5;
    unsigned rows = 0;
    for (const test::Columns& row : test::read_table("frames.tsv")) {
        const auto y = static_cast<unsigned>(number(row.at(1)));
        if (row.at(0) != name || y % step != 0)
            continue;
        ++rows;
        std::string bytes;
        for (unsigned x = 0; x < size.width; ++x)
            bytes += reference_bytes(draw_pixel(frame, size, x, y).word);
        EXPECT_EQ(crc32(bytes), std::stoul(row.at(2), nullptr, 16)) << "row " << y;
    }
    EXPECT_EQ(rows, size.height / step);
}

INSTANTIATE_TEST_SUITE_P(Whitted, Pictures,
                         testing::Values("image1", "image1_planes_reflections", "best_case"),
                         [](const auto& picture) { return picture.param; });

} // namespace
} // namespace raymarch::engine::whitted
