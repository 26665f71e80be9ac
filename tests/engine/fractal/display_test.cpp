// SPDX-License-Identifier: MIT
#include "engine/fractal/display.hpp"

#include "tests/engine/fractal/vectors.hpp"

#include <gtest/gtest.h>

namespace raymarch::engine::fractal
{
namespace
{

TEST(Display, EveryHueAndGreyOfTheHardware)
{
    std::istringstream lines(
        raymarch::test::read_text(RAYMARCH_TEST_DATA "/data/fractal/colour_lut.tsv"));
    unsigned count = 0;
    for (std::string line; std::getline(lines, line); ++count) {
        std::istringstream columns(line);
        unsigned hue = 0;
        columns >> hue >> std::hex;
        ASSERT_EQ(hue, count);
        for (const Rgb& colour : palette(Colouring::Hue, static_cast<std::uint8_t>(hue))) {
            unsigned pins = 0;
            columns >> pins;
            EXPECT_EQ(colour[0], (pins >> 8 & 15) * 17) << line;
            EXPECT_EQ(colour[1], (pins >> 4 & 15) * 17) << line;
            EXPECT_EQ(colour[2], (pins & 15) * 17) << line;
        }
        EXPECT_TRUE(columns) << line;
    }
    EXPECT_EQ(count, 256U);
}

TEST(Display, WithoutColourEveryHueIsGrey)
{
    for (unsigned hue = 0; hue < 256; ++hue) {
        const Palette greys = palette(Colouring::Grey, static_cast<std::uint8_t>(hue));
        for (unsigned grey = 0; grey < greys.size(); ++grey)
            for (const std::uint8_t channel : greys[grey])
                EXPECT_EQ(channel, 17 * grey);
    }
}

} // namespace
} // namespace raymarch::engine::fractal
