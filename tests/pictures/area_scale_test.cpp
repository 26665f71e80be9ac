// SPDX-License-Identifier: MIT
#include "pictures/area_scale.hpp"

#include "tests/pictures/test_pictures.hpp"

#include <gtest/gtest.h>

namespace raymarch::pictures
{
namespace
{

using test::byte;

engine::Image greys(engine::PictureSize size, std::vector<int> values)
{
    return test::picture(size, [&](std::size_t x, std::size_t y) {
        const std::uint8_t grey = byte(static_cast<std::size_t>(values[y * size.width + x]));
        return std::array<std::uint8_t, 3>{grey, grey, grey};
    });
}

TEST(AreaScale, ByHand)
{
    // 4x2 to 2x1: the means of four, halves up: (10+20+30+42)/4 = 25.5; (1+2+3+3)/4 = 2.25.
    EXPECT_EQ(area_scaled(greys({4, 2}, {10, 20, 1, 2, 30, 42, 3, 3}), {2, 1}).rgb,
              greys({2, 1}, {26, 2}).rgb);
    // 3x1 to 2x1: (2*30 + 60)/3 = 40; (60 + 2*90)/3 = 80.
    EXPECT_EQ(area_scaled(greys({3, 1}, {30, 60, 90}), {2, 1}).rgb, greys({2, 1}, {40, 80}).rgb);
    // 2x1 to 3x1: the middle one covers half of each.
    EXPECT_EQ(area_scaled(greys({2, 1}, {30, 60}), {3, 1}).rgb, greys({3, 1}, {30, 45, 60}).rgb);
    // 1x3 to 1x2, the other way round.
    EXPECT_EQ(area_scaled(greys({1, 3}, {30, 60, 90}), {1, 2}).rgb, greys({1, 2}, {40, 80}).rgb);
}

TEST(AreaScale, WholeFactorsRepeatAndGoBack)
{
    const engine::Image image = test::noise({7, 5}, 1000);
    EXPECT_EQ(area_scaled(image, image.size).rgb, image.rgb);
    const engine::Image larger = area_scaled(image, {28, 20});
    for (std::size_t y = 0; y < 20; ++y)
        for (std::size_t x = 0; x < 28; ++x)
            ASSERT_EQ(test::pixel(larger, x, y), test::pixel(image, x / 4, y / 4));
    EXPECT_EQ(area_scaled(larger, image.size).rgb, image.rgb);
}

TEST(AreaScale, ThePlainColourStays)
{
    const engine::Image white = greys({37, 23}, std::vector<int>(37 * 23, 255));
    for (const engine::PictureSize size : {engine::PictureSize{1, 1}, {36, 22}, {5, 19}, {50, 7}})
        EXPECT_EQ(area_scaled(white, size).rgb,
                  std::vector<std::uint8_t>(3U * size.width * size.height, 255));
}

TEST(AreaScale, TheLargestPictureDoesNotOverflow)
{
    const engine::Image wide = greys({65535, 2}, std::vector<int>(65535 * 2, 255));
    EXPECT_EQ(area_scaled(wide, {3, 1}).rgb, std::vector<std::uint8_t>(9, 255));
}

} // namespace
} // namespace raymarch::pictures
