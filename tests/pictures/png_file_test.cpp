// SPDX-License-Identifier: MIT
#include "pictures/picture_file.hpp"
#include "tests/pictures/test_pictures.hpp"

#include <gtest/gtest.h>
#include <png.h>

namespace raymarch::pictures
{
namespace
{

/// By libpng's reader; without pixels when that refuses the file.
engine::Image decoded_png(const std::vector<std::uint8_t>& bytes)
{
    png_image png = {};
    png.version = PNG_IMAGE_VERSION;
    if (::png_image_begin_read_from_memory(&png, bytes.data(), bytes.size()) == 0) {
        ADD_FAILURE() << png.message;
        return engine::Image({0, 0});
    }
    EXPECT_EQ(png.format, png_uint_32{PNG_FORMAT_RGB}) << "neither grey, nor a palette, nor alpha";
    engine::Image image(engine::PictureSize{static_cast<std::uint16_t>(png.width),
                                            static_cast<std::uint16_t>(png.height)});
    EXPECT_NE(::png_image_finish_read(&png, nullptr, image.rgb.data(), 0, nullptr), 0)
        << png.message;
    return image;
}

TEST(Png, HoldsThePixels)
{
    for (const engine::PictureSize size :
         {engine::PictureSize{1, 1}, engine::PictureSize{9, 7}, engine::PictureSize{320, 240},
          engine::PictureSize{1, 300}}) {
        const engine::Image image = test::noise(size, 1000);
        const auto bytes = encode(image, PictureFormat::Png);
        ASSERT_TRUE(bytes) << bytes.error().message;
        const engine::Image back = decoded_png(*bytes);
        EXPECT_EQ(back.size, size);
        EXPECT_TRUE(back.rgb == image.rgb);
    }
}

TEST(Png, IsSmallerThanThePixelsWhereTheyAreAlike)
{
    const engine::Image image = test::noise({320, 240}, 1);
    EXPECT_LT(encode(image, PictureFormat::Png).value().size(), image.rgb.size() / 50);
}

TEST(Png, APictureWithoutPixelsIsRefusedInLibpngsWords)
{
    const auto bytes = encode(engine::Image({0, 7}), PictureFormat::Png);
    ASSERT_FALSE(bytes);
    EXPECT_EQ(bytes.error().kind, ErrorKind::InputOutput);
    EXPECT_TRUE(bytes.error().message.starts_with("libpng could not encode the picture: "))
        << bytes.error().message;
}

} // namespace
} // namespace raymarch::pictures
