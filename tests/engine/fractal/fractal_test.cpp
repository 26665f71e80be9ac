// SPDX-License-Identifier: MIT
#include "engine/fractal/fractal.hpp"

#include "base/crc32.hpp"
#include "engine/fractal/controller.hpp"
#include "protocol/accelerators/fractal.hpp"
#include "tests/engine/fractal/vectors.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <ostream>
#include <string>
#include <vector>

namespace raymarch::engine::fractal
{
namespace
{

struct Drawn
{
    Image image;
    std::vector<PixelCost> costs;
};

void draw_into(Drawn& drawn, const Frame& frame, std::uint32_t number)
{
    const PictureSize size = drawn.image.size;
    drawn.costs.resize(std::size_t{size.width} * size.height);
    for (std::uint16_t y = 0; y < size.height; ++y)
        draw_row(frame, {size, y, number}, drawn.image.row(y),
                 std::span(drawn.costs).subspan(std::size_t{y} * size.width, size.width));
}

Drawn draw(const Frame& frame, PictureSize size, std::uint32_t number)
{
    Drawn drawn{Image(size), {}};
    draw_into(drawn, frame, number);
    return drawn;
}

/// The greys of a row; its three channels must be equal, and multiples of 17.
std::string greys(std::span<const std::uint8_t> row)
{
    std::string greys;
    for (std::size_t i = 0; i < row.size(); i += bytes_per_pixel) {
        EXPECT_TRUE(row[i] % 17 == 0 && row[i] == row[i + 1] && row[i] == row[i + 2]);
        greys.push_back(static_cast<char>(row[i] / 17));
    }
    return greys;
}

RowOf last_row(std::uint32_t number)
{
    return {test::size, static_cast<std::uint16_t>(test::size.height - 1), number};
}

class Hardware : public testing::TestWithParam<test::Vector>
{};

// Pixels that the checkerboard leaves out hold 0 in the hardware's frame, which began black.
TEST_P(Hardware, FrameAndCycles)
{
    const test::Vector& vector = GetParam();
    Drawn drawn = draw(vector.frame, test::size, vector.number);
    ASSERT_EQ(vector.rows.size(), test::size.height);
    for (std::uint16_t y = 0; y < test::size.height; ++y)
        ASSERT_EQ(crc32(greys(drawn.image.row(y))), vector.rows[y]) << "row " << y;

    std::uint64_t evaluations = 0;
    for (const PixelCost& cost : drawn.costs)
        evaluations += cost.steps;
    EXPECT_EQ(evaluations, vector.evaluations);
    EXPECT_FALSE(vector.cycles.empty());
    for (const auto& [units, cycles] : vector.cycles)
        EXPECT_EQ(frame_cycles(vector.frame, last_row(vector.number), drawn.costs, units), cycles)
            << units << " units";
}

INSTANTIATE_TEST_SUITE_P(All, Hardware, testing::ValuesIn(test::vectors()), [](const auto& row) {
    std::string name = row.param.name;
    std::erase_if(name, [](char c) { return c == '.' || c == '_'; });
    return name;
});

/// Cycles at the start view: measured with 4, 8 and 12 units. Those of the checkerboard are the
/// mean of its two halves, to an integer.
struct AtStart
{
    Scene scene;
    std::array<std::uint64_t, 3> plain;
    std::array<std::uint64_t, 3> checker;
};

void PrintTo(const AtStart& row, std::ostream* stream)
{
    *stream << protocol::fractal::scenes.at(static_cast<std::size_t>(row.scene));
}

class StartView : public testing::TestWithParam<AtStart>
{};

TEST_P(StartView, Cycles)
{
    const AtStart& expected = GetParam();
    Frame frame{.position = {word(0), one, -three_halves},
                .forward = {word(0), word(0), one},
                .scene = expected.scene};
    const Drawn drawn = draw(frame, test::size, 0);
    constexpr std::array units = {4U, 8U, 12U};
    for (std::size_t i = 0; i < units.size(); ++i) {
        frame.checker = false;
        EXPECT_EQ(frame_cycles(frame, last_row(0), drawn.costs, units[i]), expected.plain[i]);
        frame.checker = true; // the costs of pixels left out do not count
        const std::uint64_t both = frame_cycles(frame, last_row(0), drawn.costs, units[i]) +
                                   frame_cycles(frame, last_row(1), drawn.costs, units[i]);
        EXPECT_LE(both, 2 * expected.checker[i] + 1) << units[i];
        EXPECT_GE(both, 2 * expected.checker[i] - 1) << units[i];
    }
}

INSTANTIATE_TEST_SUITE_P(
    Scenes, StartView,
    testing::Values(
        AtStart{Scene::Menger, {1'899'822, 972'643, 671'310}, {1'009'946, 546'379, 395'688}},
        AtStart{Scene::Cubes, {1'082'564, 579'437, 418'838}, {601'388, 349'656, 269'388}},
        AtStart{Scene::Cube, {1'114'020, 589'527, 400'465}, {617'052, 354'785, 260'330}},
        AtStart{Scene::Maze, {4'588'311, 2'333'493, 1'582'521}, {2'354'182, 1'226'795, 851'303}}),
    [](const auto& row) { return testing::PrintToString(row.param); });

TEST(Fractal, ACheckerboardKeepsTheOtherHalf)
{
    constexpr PictureSize size{8, 4};
    const Frame frame{.position = {},
                      .forward = {word(0), word(0), one},
                      .scene = Scene::Cube,
                      .checker = true}; // inside the cube: white everywhere
    Drawn drawn{Image(size), {}};
    std::ranges::fill(drawn.image.rgb, std::uint8_t{7});
    draw_into(drawn, frame, 0);
    for (unsigned i = 0; i < 32; ++i) {
        const bool in_half = (i / 8 + i % 8) % 2 != 0;
        EXPECT_EQ(drawn.image.rgb[3 * i], in_half ? 255 : 7) << i;
        EXPECT_EQ(drawn.costs[i], (in_half ? PixelCost{1, 1} : PixelCost{})) << i;
    }
    draw_into(drawn, frame, 1);
    EXPECT_EQ(drawn.image.rgb, std::vector<std::uint8_t>(drawn.image.rgb.size(), 255));
}

TEST(Fractal, FourFramesOfACheckerboardAreAPicture)
{
    constexpr PictureSize size{40, 30};
    Frame frame{.position = {word(0), one, -three_halves},
                .forward = {word(0), word(0), one},
                .dither = true,
                .texture = true};
    const Drawn plain = draw(frame, size, 0);
    EXPECT_EQ(frames_of_a_still(frame), 1U);
    frame.checker = true;
    ASSERT_EQ(frames_of_a_still(frame), 4U);
    std::array buffers = {Drawn{Image(size), {}}, Drawn{Image(size), {}}};
    for (std::uint32_t number = 0; number < 4; ++number)
        draw_into(buffers[number % 2], frame, number);
    EXPECT_EQ(buffers[0].image.rgb, plain.image.rgb);
    EXPECT_EQ(buffers[1].image.rgb, plain.image.rgb);
}

TEST(Fractal, OnlyColourIsColoured)
{
    constexpr PictureSize size{4, 3};
    Frame frame{.forward = {word(0), word(0), one}, .scene = Scene::Cube, .hue = 85};
    EXPECT_EQ(draw(frame, size, 0).image.rgb[1], 255); // white by depth 0
    frame.colour = true;
    const Drawn drawn = draw(frame, size, 0);
    EXPECT_EQ(drawn.image.rgb[0], 0xEE); // row 85 of the table, grey 15
    EXPECT_EQ(drawn.image.rgb[1], 0xFF);
    EXPECT_EQ(drawn.image.rgb[2], 0xEE);
}

TEST(Fractal, EveryWordDrawsAPicture) // and nothing is undefined: the sanitizers look on
{
    constexpr PictureSize size{24, 1};
    const std::array extremes = {word(-2097152), word(2097151), word(-1), word(0), word(1 << 16)};
    for (const Number p : extremes)
        for (const Number f : extremes)
            for (unsigned scene = 0; scene < 4; ++scene) {
                const Frame frame{.position = {p, f, p},
                                  .forward = {f, p, f},
                                  .scene = static_cast<Scene>(scene),
                                  .dither = true,
                                  .texture = true};
                for (const PixelCost& cost : draw(frame, size, 0).costs)
                    EXPECT_TRUE(cost.steps >= 1 && cost.steps <= 32);
            }
}

} // namespace
} // namespace raymarch::engine::fractal
