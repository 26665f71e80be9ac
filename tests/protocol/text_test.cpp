// SPDX-License-Identifier: MIT
#include "protocol/text.hpp"

#include "protocol/checksum.hpp"
#include "protocol/picture_size.hpp"

#include <gtest/gtest.h>

#include <string_view>

namespace raymarch::protocol
{
namespace
{

TEST(Text, AsciiCaseOnly)
{
    EXPECT_EQ(to_upper('z'), 'Z');
    EXPECT_EQ(to_upper('{'), '{');
    EXPECT_EQ(to_lower('A'), 'a');
    EXPECT_EQ(to_upper('\xE4'), '\xE4'); // no locale
    EXPECT_TRUE(is_letter('q'));
    EXPECT_FALSE(is_letter('@'));
    EXPECT_FALSE(is_letter('['));
    EXPECT_TRUE(equal_ignoring_case("Infinite_Cube", "INFINITE_cube"));
    EXPECT_FALSE(equal_ignoring_case("cube", "cub"));
    EXPECT_TRUE(equal_ignoring_case("", ""));
}

TEST(Text, TrimmingKeepsTheColumn)
{
    const Text text{.bytes = " \t ab \t", .column = 5};
    EXPECT_EQ(text.trimmed().bytes, "ab");
    EXPECT_EQ(text.trimmed().column, 8U);
    const Text blank{.bytes = "  ", .column = 5};
    EXPECT_TRUE(blank.trimmed().empty());
    EXPECT_EQ(blank.trimmed().column, 7U); // the end
}

TEST(Text, TakingPiecesMovesTheRest)
{
    Text rest{.bytes = "a,,b"};
    const Piece first = take_until(rest, ',');
    EXPECT_EQ(first.text.bytes, "a");
    EXPECT_TRUE(first.found);
    const Piece second = take_until(rest, ',');
    EXPECT_TRUE(second.text.empty());
    EXPECT_EQ(second.text.column, 3U);
    const Piece third = take_until(rest, ',');
    EXPECT_EQ(third.text.bytes, "b");
    EXPECT_EQ(third.text.column, 4U);
    EXPECT_FALSE(third.found);
    const Piece behind = take_until(rest, ',');
    EXPECT_TRUE(behind.text.empty());
    EXPECT_EQ(behind.text.column, 5U);
}

TEST(Text, ChecksumsAreTheXorOfAllBytes)
{
    EXPECT_EQ(xor_of(""), 0x00);
    EXPECT_EQ(xor_of("PING"), 0x10); // 50 49 4E 47
    EXPECT_EQ(xor_of("\xFF\x0F"), 0xF0);
    EXPECT_EQ(hex_value('f'), 15);
    EXPECT_EQ(hex_value('A'), 10);
    EXPECT_EQ(hex_value('0'), 0);
    EXPECT_FALSE(hex_value('G'));
    EXPECT_FALSE(hex_value(' '));
}

TEST(PictureSize, TwoNumbersJoinedByAnX)
{
    constexpr PictureSize largest{1920, 1080};
    EXPECT_EQ(parse_size("640x480", largest), (PictureSize{640, 480}));
    EXPECT_EQ(parse_size("1x1", largest), (PictureSize{1, 1}));
    EXPECT_EQ(parse_size("1920x1080", largest), (PictureSize{1920, 1080}));
    for (const std::string_view text :
         {"", "x", "640", "640x", "x480", "0x480", "640x0", "1921x1080", "1920x1081", "640X480",
          "640x480x1", " 640x480", "640x480 ", "-1x1", "+1x1", "65537x1", "640 x 480"})
        EXPECT_FALSE(parse_size(text, largest)) << "'" << text << "'";
}

TEST(Tile, IsASizeAndACornerInsideThePicture)
{
    constexpr PictureSize picture{64, 48};
    const auto tile = parse_tile("16x8+48+40", picture);
    ASSERT_TRUE(tile);
    EXPECT_EQ(tile->size, (PictureSize{16, 8}));
    EXPECT_EQ(tile->x, 48);
    EXPECT_EQ(tile->y, 40);
    EXPECT_TRUE(parse_tile("64x48+0+0", picture));
    for (const char* text :
         {"", "16x8", "16x8+0", "16x8+0+", "16x8++0", "16x8+0+0 ", "16x8+49+0", "16x8+0+41",
          "16x8+-1+0", "16x8+0+0x", "65x1+0+0", "0x1+0+0", "1x1+65536+0", "x+0+0"})
        EXPECT_FALSE(parse_tile(text, picture)) << "'" << text << "'";
}

} // namespace
} // namespace raymarch::protocol
