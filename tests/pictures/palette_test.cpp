// SPDX-License-Identifier: MIT
#include "pictures/palette.hpp"

#include "tests/pictures/test_pictures.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>

namespace raymarch::pictures
{
namespace
{

using test::byte;

engine::Image shown(const IndexedImage& indexed)
{
    engine::Image image(indexed.size);
    for (std::size_t i = 0; i < indexed.indices.size(); ++i)
        std::copy_n(indexed.palette.at(indexed.indices[i]).begin(), 3, &image.rgb[3 * i]);
    return image;
}

TEST(Palette, UpTo256ColoursAreKept)
{
    for (const std::size_t colours : {1U, 2U, 3U, 17U, 255U, 256U}) {
        const engine::Image image = test::picture({64, 8}, [&](std::size_t x, std::size_t y) {
            const std::size_t colour = (y * 64 + x) % colours;
            return Colour{byte(colour * 3), byte(200 - colour), byte(colour)};
        });
        const IndexedImage result = indexed(image);
        EXPECT_EQ(result.palette.size(), colours);
        EXPECT_EQ(shown(result).rgb, image.rgb);
        EXPECT_TRUE(std::is_sorted(result.palette.begin(), result.palette.end()));
    }
}

TEST(Palette, OneColourMoreMergesTheTwoThatAreNearest)
{
    // 256 colours far apart, and one beside a grey that is there once as well.
    const engine::Image image = test::picture({257, 1}, [](std::size_t x, std::size_t) {
        return x < 256 ? Colour{byte(x % 16 * 17), byte(x / 16 * 17), 0} : Colour{17, 17, 1};
    });
    const IndexedImage result = indexed(image);
    EXPECT_EQ(result.palette.size(), 256U);
    EXPECT_EQ(result.indices[17], result.indices[256]);
    const engine::Image back = shown(result);
    EXPECT_TRUE(std::equal(image.rgb.begin(), image.rgb.end() - 3, back.rgb.begin(),
                           [](int a, int b) { return std::abs(a - b) <= 1; }));
}

TEST(Palette, AGradientStaysClose)
{
    const engine::Image image = test::picture({256, 64}, [](std::size_t x, std::size_t y) {
        return Colour{byte(x), byte(x / 2), byte(y)};
    });
    const IndexedImage result = indexed(image);
    EXPECT_EQ(result.palette.size(), 256U);
    const engine::Image back = shown(result);
    int worst = 0;
    for (std::size_t i = 0; i < image.rgb.size(); ++i)
        worst = std::max(worst, std::abs(image.rgb[i] - back.rgb[i]));
    EXPECT_LE(worst, 8); // 16384 colours in 256 boxes of about 8x8
}

TEST(Palette, EqualMeansAreOneColour)
{
    // Far more colours than fit, all within a step or two: means coincide, nothing is lost in
    // range.
    const engine::Image image = test::picture({512, 4}, [](std::size_t x, std::size_t y) {
        return Colour{byte(x % 8), byte(x / 8 % 8), byte(x / 64 + y % 2)};
    });
    const IndexedImage result = indexed(image);
    EXPECT_LE(result.palette.size(), 256U);
    EXPECT_TRUE(std::adjacent_find(result.palette.begin(), result.palette.end()) ==
                result.palette.end());
    EXPECT_EQ(indexed(image).indices, result.indices);
}

TEST(Palette, APictureWithoutPixels)
{
    EXPECT_TRUE(indexed(engine::Image()).indices.empty());
}

} // namespace
} // namespace raymarch::pictures
