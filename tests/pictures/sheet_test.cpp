// SPDX-License-Identifier: MIT
#include "pictures/sheet.hpp"

#include "pictures/area_scale.hpp"
#include "pictures/small_font.hpp"
#include "tests/pictures/test_pictures.hpp"

#include <gtest/gtest.h>

#include <set>
#include <string>

namespace raymarch::pictures
{
namespace
{

using engine::Image;
using engine::PictureSize;
using test::pixel;

constexpr Colour black{0, 0, 0};
constexpr Colour white{255, 255, 255};
constexpr Colour red{255, 0, 0};
constexpr SheetLayout small{
    .columns = 2, .cell = {40, 20}, .gap = 3, .text_scale = 1, .background = black, .text = white};

Image plain(PictureSize size, Colour colour)
{
    return test::picture(size, [&](std::size_t, std::size_t) { return colour; });
}

/// A part of the sheet as text: # where it is not background.
std::string shape(const Image& sheet, std::size_t left, std::size_t top, std::size_t width,
                  std::size_t height)
{
    std::string text;
    for (std::size_t y = top; y < top + height; ++y) {
        for (std::size_t x = left; x < left + width; ++x)
            text += pixel(sheet, x, y) == black ? '.' : '#';
        text += '\n';
    }
    return text;
}

TEST(Sheet, HowLargeAPictureIsInItsCell)
{
    struct Row
    {
        PictureSize picture;
        PictureSize cell;
        PictureSize expected;
    };
    for (const Row& row : {
             Row{{320, 240}, {320, 240}, {320, 240}},
             Row{{100, 240}, {320, 240}, {100, 240}}, // fits: as it is
             Row{{81, 60}, {320, 240}, {81, 60}},     // room for 3.95 times its size: as it is
             Row{{80, 60}, {320, 240}, {320, 240}},   // for four: enlarged
             Row{{16, 2}, {100, 90}, {96, 12}},       // six times
             Row{{640, 480}, {320, 240}, {320, 240}},
             Row{{1920, 1080}, {320, 240}, {320, 180}},
             Row{{1080, 1920}, {320, 240}, {135, 240}},
             Row{{321, 240}, {320, 240}, {320, 239}}, // 239.25
             Row{{65535, 1}, {320, 240}, {320, 1}},   // not to nothing
             Row{{65535, 65535}, {320, 240}, {240, 240}},
         })
        EXPECT_EQ(size_in_cell(row.picture, row.cell), row.expected)
            << row.picture.width << 'x' << row.picture.height;
}

TEST(Sheet, HowLargeItIs)
{
    // 3 + 2 * (40 + 3); 3 + rows * (20 + 3 + 7 + 3)
    EXPECT_EQ(sheet_size(0, small), (PictureSize{89, 3}));
    EXPECT_EQ(sheet_size(1, small), (PictureSize{89, 36}));
    EXPECT_EQ(sheet_size(2, small), (PictureSize{89, 36}));
    EXPECT_EQ(sheet_size(3, small), (PictureSize{89, 69}));
    SheetLayout layout = small;
    layout.columns = 0; // as many as rows, or one more row's worth
    EXPECT_EQ(sheet_size(4, layout), (PictureSize{89, 69}));
    EXPECT_EQ(sheet_size(5, layout), (PictureSize{132, 69}));
    EXPECT_EQ(sheet_size(9, layout), (PictureSize{132, 102}));
    layout.text_scale = 0;
    EXPECT_EQ(sheet_size(4, layout), (PictureSize{89, 49}));
}

TEST(Sheet, PicturesStandInTheMiddleOfTheirCells)
{
    const std::vector<SheetEntry> entries = {
        {plain({40, 20}, red), ""}, {plain({20, 10}, red), ""}, {plain({80, 20}, red), ""}};
    const Image sheet = contact_sheet(entries, small);
    ASSERT_EQ(sheet.size, sheet_size(3, small));
    const auto is_red = [&](std::size_t x, std::size_t y) {
        const bool first = x >= 3 && x < 43 && y >= 3 && y < 23;
        const bool second = x >= 56 && x < 76 && y >= 8 && y < 18;
        const bool third = x >= 3 && x < 43 && y >= 41 && y < 51; // half as large
        return first || second || third;
    };
    for (std::size_t y = 0; y < sheet.size.height; ++y)
        for (std::size_t x = 0; x < sheet.size.width; ++x)
            ASSERT_EQ(pixel(sheet, x, y), is_red(x, y) ? red : black) << x << ',' << y;
}

TEST(Sheet, PicturesAreScaledByArea)
{
    const Image picture = test::noise({77, 40}, 5000);
    SheetLayout layout = small;
    layout.columns = 1;
    const Image sheet = contact_sheet(std::vector{SheetEntry{picture, ""}}, layout);
    const Image scaled = area_scaled(picture, {39, 20}); // 38.5
    for (std::size_t y = 0; y < 20; ++y)
        for (std::size_t x = 0; x < 39; ++x)
            ASSERT_EQ(pixel(sheet, 3 + x, 3 + y), pixel(scaled, x, y));
}

TEST(Sheet, CaptionsStandBelowInTheMiddle)
{
    const Image sheet = contact_sheet(std::vector{SheetEntry{Image(), "Ab7"}}, small);
    // 17 wide in 40: from 3 + 11; 3 below the cell.
    EXPECT_EQ(shape(sheet, 14, 26, 17, 7), "..#...#.....#####\n"
                                           ".#.#..#.........#\n"
                                           "#...#.####.....#.\n"
                                           "#...#.#...#...#..\n"
                                           "#####.#...#..#...\n"
                                           "#...#.#...#..#...\n"
                                           "#...#.####...#...\n");
    EXPECT_EQ(pixel(sheet, 16, 26), white);
    EXPECT_EQ(shape(sheet, 0, 0, 89, 26).find('#'), std::string::npos);
}

TEST(Sheet, CaptionsThatAreTooLongAreCut)
{
    // (40 + 1) / 6 letters.
    const auto caption = [](const char* text) {
        return contact_sheet(std::vector{SheetEntry{Image(), text}}, small).rgb;
    };
    EXPECT_NE(caption("sixsix"), caption("sixs.."));
    EXPECT_EQ(caption("sevense"), caption("seve.."));
    EXPECT_EQ(caption("a caption that goes on and on"), caption("a ca.."));
    SheetLayout narrow = small;
    for (const std::uint16_t width :
         std::initializer_list<std::uint16_t>{0, 1, 5, 11, 17}) { // no letter, one, two
        narrow.cell.width = width;
        EXPECT_EQ(contact_sheet(std::vector{SheetEntry{plain({9, 9}, red), "long"}}, narrow).size,
                  sheet_size(1, narrow));
    }
}

TEST(Sheet, TextIsEnlargedInWholeSteps)
{
    SheetLayout layout = small;
    layout.text_scale = 3;
    const Image sheet = contact_sheet(std::vector{SheetEntry{Image(), "I"}}, layout);
    // 15 wide in 40: from 3 + 12; 9 below the cell. The top of an I is three dots wide.
    EXPECT_EQ(shape(sheet, 15, 32, 15, 3), "...#########...\n...#########...\n...#########...\n");
    EXPECT_EQ(shape(sheet, 15, 35, 15, 1), "......###......\n");
}

TEST(Sheet, IsTheSameEachTime)
{
    const std::vector<SheetEntry> entries = {{test::noise({64, 48}, 999), "one"},
                                             {test::noise({500, 300}, 999), "two"}};
    EXPECT_EQ(contact_sheet(entries).rgb, contact_sheet(entries).rgb);
}

TEST(SmallFont, EveryCharacterHasAShapeOfItsOwn)
{
    std::set<std::string> shapes;
    const auto shape_of = [](char character) {
        std::string text;
        for (std::size_t y = 0; y < glyph_height; ++y)
            for (std::size_t x = 0; x < glyph_width; ++x)
                text += has_dot(character, x, y) ? '#' : '.';
        return text;
    };
    for (int c = ' '; c <= '~'; ++c)
        EXPECT_TRUE(shapes.insert(shape_of(static_cast<char>(c))).second) << static_cast<char>(c);
    EXPECT_EQ(shape_of(' ').find('#'), std::string::npos);
    for (const char c : {'\n', '\x7F', '\xC3', '\0'})
        EXPECT_FALSE(shapes.contains(shape_of(c)));
    EXPECT_EQ(shape_of('\n'), shape_of('\xC3'));
}

} // namespace
} // namespace raymarch::pictures
