// SPDX-License-Identifier: MIT
#include "pictures/netpbm.hpp"

#include "pictures/picture_file.hpp"
#include "tests/fakes/random.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace raymarch::pictures
{
namespace
{

using Samples = std::vector<std::uint8_t>;
using namespace std::string_literals;

std::string why_not(const std::string& bytes)
{
    const auto image = decode_netpbm(bytes);
    if (image)
        return "";
    EXPECT_EQ(image.error().kind, ErrorKind::BadData);
    return image.error().message;
}

TEST(Netpbm, GreyAndColour)
{
    const auto grey = decode_netpbm("P5\n2 1\n255\n\x07\xFF"s);
    ASSERT_TRUE(grey) << grey.error().message;
    EXPECT_EQ(grey->size, (engine::PictureSize{2, 1}));
    EXPECT_EQ(grey->rgb, (Samples{7, 7, 7, 255, 255, 255}));
    const auto colour = decode_netpbm("P6 1 2 255\n\1\2\3\4\5\6"s);
    ASSERT_TRUE(colour) << colour.error().message;
    EXPECT_EQ(colour->size, (engine::PictureSize{1, 2}));
    EXPECT_EQ(colour->rgb, (Samples{1, 2, 3, 4, 5, 6}));
}

TEST(Netpbm, AMaximumOfFifteenIsStretched)
{
    const auto grey = decode_netpbm("P5 3 1 15 \0\1\xF"s);
    ASSERT_TRUE(grey) << grey.error().message;
    EXPECT_EQ(grey->rgb, (Samples{0, 0, 0, 17, 17, 17, 255, 255, 255}));
    EXPECT_EQ(why_not("P5 3 1 15 \0\1\x10"s), "has a sample of 16 above its maximum");
}

TEST(Netpbm, CommentsAndWhiteSpaceInTheHeader)
{
    const auto image = decode_netpbm("P5# made by hand\r\n#\n 1\t\n# 9 9\n1 255\n#"s);
    ASSERT_TRUE(image) << image.error().message;
    EXPECT_EQ(image->rgb, (Samples{'#', '#', '#'})) << "after the maximum there are no comments";
}

TEST(Netpbm, ReadsWhatIsWritten)
{
    auto random = test::seeded_random();
    engine::Image image(engine::PictureSize{.width = 31, .height = 17});
    for (std::uint8_t& sample : image.rgb)
        sample = static_cast<std::uint8_t>(random());
    const auto bytes = encode(image, PictureFormat::Ppm);
    ASSERT_TRUE(bytes);
    const auto read = decode_netpbm(std::string(bytes->begin(), bytes->end()));
    ASSERT_TRUE(read) << read.error().message;
    EXPECT_EQ(read->size, image.size);
    EXPECT_EQ(read->rgb, image.rgb);
}

TEST(Netpbm, RefusesEverythingElse)
{
    EXPECT_EQ(why_not(""), "is no binary PGM or PPM picture (P5, P6)");
    EXPECT_EQ(why_not("P2\n1 1\n255\n0"), "is no binary PGM or PPM picture (P5, P6)");
    const std::string header = "has no header of width, height and maximum";
    for (const char* const bytes :
         {"P5", "P5#", "P5 1", "P5 1 1", "P5 1 1 255", "P5 0 1 255\n", "P5 1 0 255\n",
          "P5 -1 1 255\nx", "P5 65536 1 255\n", "P5 1 1 255x", "P5 1 1 99999 x", "P51 1 255 x",
          "P5x 1 1 255 x", "P5 # 1 1 255 x"})
        EXPECT_EQ(why_not(bytes), header) << bytes;
    EXPECT_EQ(why_not("P5 1 1 65535\nxx"), "has a maximum of 65535; 255 and 15 are read");
    EXPECT_EQ(why_not("P5 1 1 0\nx"), "has a maximum of 0; 255 and 15 are read");
    EXPECT_EQ(why_not("P5 2 1 255\nx"), "has 1 bytes of pixels in place of 2x1x1");
    EXPECT_EQ(why_not("P6 2 1 255\nxxxxxxx"), "has 7 bytes of pixels in place of 2x1x3");
    EXPECT_EQ(why_not("P6 65535 65535 255\n"), "has 0 bytes of pixels in place of 65535x65535x3");
}

} // namespace
} // namespace raymarch::pictures
