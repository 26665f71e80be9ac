// SPDX-License-Identifier: MIT
#include "engine/progressive.hpp"

#include "engine/draw.hpp"
#include "engine/models.hpp"
#include "protocol/registers.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace raymarch::engine
{
namespace
{

constexpr PictureSize sizes[] = {{1, 1}, {2, 1}, {1, 9}, {5, 3}, {8, 8}, {9, 17}, {31, 23}};

/// How often each pixel is drawn by the passes up to and with `last`.
std::vector<int> counts(PictureSize size, const Pass& last)
{
    std::vector<int> drawn(std::size_t{size.width} * size.height);
    for (const Pass* pass = passes.data(); pass <= &last; ++pass) {
        const Region region = region_of(*pass, size);
        for (unsigned y = region.y; y < unsigned{region.y} + region.height; y += region.step)
            for (unsigned x = region.x; x < unsigned{region.x} + region.width; x += region.step)
                ++drawn[std::size_t{y} * size.width + x];
    }
    return drawn;
}

TEST(Passes, TogetherDrawEachPixelOnce)
{
    for (const PictureSize size : sizes)
        EXPECT_TRUE(std::ranges::all_of(counts(size, passes.back()), [](int n) { return n == 1; }))
            << size.width << "x" << size.height;
}

TEST(Passes, WithAGridHaveDrawnAllOfIt)
{
    for (const PictureSize size : sizes)
        for (const Pass& pass : passes) {
            if (pass.grid == 0)
                continue;
            const std::vector<int> drawn = counts(size, pass);
            for (std::size_t y = 0; y < size.height; ++y)
                for (std::size_t x = 0; x < size.width; ++x)
                    EXPECT_EQ(drawn[y * size.width + x],
                              x % pass.grid == 0 && y % pass.grid == 0 ? 1 : 0);
        }
}

TEST(Passes, EndInTheSamePictureForEveryModel)
{
    for (const Model& model : models) {
        if (model.ordered)
            continue; // its pixels depend on one another
        const protocol::Words words =
            protocol::pack(*model.description, protocol::initial_state(*model.description));
        const PictureSize size{29, 13};
        Painter painter(2);
        const Drawing drawing{model, words, kernel_of(model)};
        Image expected(size);
        draw_still(painter, drawing, expected);
        Image drawn(size);
        for (const Pass& pass : passes)
            painter.draw(drawing, region_of(pass, size), {drawn.rgb});
        EXPECT_EQ(drawn.rgb, expected.rgb) << model.description->name;
    }
}

TEST(Passes, AreShownAsSquares)
{
    Image drawn({5, 3});
    for (std::size_t i = 0; i < drawn.rgb.size(); ++i)
        drawn.rgb[i] = static_cast<std::uint8_t>(i);
    Image shown({5, 3});
    spread(drawn, 2, shown);
    const std::vector<int> columns = {0, 0, 2, 2, 4};
    const std::vector<std::size_t> rows = {0, 0, 2};
    for (std::size_t y = 0; y < 3; ++y)
        for (std::size_t x = 0; x < 5; ++x)
            EXPECT_EQ(shown.row(y)[3 * x + 1],
                      drawn.row(rows[y])[3 * static_cast<std::size_t>(columns[x]) + 1]);
}

TEST(Tiles, HoldThePixelsOfTheWholePicture)
{
    for (const Model& model : models) {
        const protocol::Words words =
            protocol::pack(*model.description, protocol::initial_state(*model.description));
        const PictureSize size{29, 13};
        Painter painter(2);
        const Drawing drawing{model, words, kernel_of(model)};
        Image expected(size);
        draw_still(painter, drawing, expected);
        Image drawn(size);
        draw_still(painter, drawing, {.size = size, .x = 7, .y = 2, .width = 11, .height = 9},
                   drawn);
        for (std::size_t y = 2; y < 11; ++y)
            EXPECT_TRUE(std::ranges::equal(drawn.row(y).subspan(3 * 7, 3 * 11),
                                           expected.row(y).subspan(3 * 7, 3 * 11)))
                << model.description->name << " row " << y;
    }
}

} // namespace
} // namespace raymarch::engine
