// SPDX-License-Identifier: MIT
#include "engine/marcher/shading.hpp"

#include <gtest/gtest.h>

#include <array>

namespace raymarch::engine::marcher
{
namespace
{

constexpr int one = 1 << 24;

Point point(int x, int y, int z)
{
    return {Coordinate::from_raw(x), Coordinate::from_raw(y), Coordinate::from_raw(z)};
}

struct BrightnessRow
{
    std::array<int, 3> normal;
    std::array<int, 3> light;
    int brightness;
};

constexpr std::array brightness_rows = {
    BrightnessRow{{0, one, 0}, {0, one, 0}, one},                 // 1/8 + 1/8 + 3/4
    BrightnessRow{{0, 0, one}, {0, 0, one}, 14'680'064},          // 1/8 + 3/4
    BrightnessRow{{0, one, 0}, {0, -one, 0}, one / 4},            // 1/8 + 1/8: the light is behind
    BrightnessRow{{0, -one, 0}, {0, one, 0}, one / 8},            // the ambient light alone
    BrightnessRow{{0, 0, 0}, {one, 0, 0}, one / 8},               // no normal
    BrightnessRow{{0, 7, 0}, {0, 0, 0}, one / 8},                 // 7 >> 3
    BrightnessRow{{0, 15, 0}, {0, 0, 0}, one / 8 + 1},            // 15 >> 3
    BrightnessRow{{one, 0, 0}, {5, 0, 0}, one / 8 + 3},           // 3 * 5 >> 2
    BrightnessRow{{1, 0, 0}, {-1, 0, 0}, one / 8},                // -1 >> 24 is -1, and held at 0
    BrightnessRow{{1 << 23, 0, 1 << 23}, {1, 0, 1}, one / 8},     // 1 >> 0, but 3 * 1 >> 2 is 0
    BrightnessRow{{1 << 23, 0, 1 << 23}, {3, 0, 1}, one / 8 + 1}, // one shift for the sum: 2
};

TEST(Shading, BrightnessByHand)
{
    for (const BrightnessRow& row : brightness_rows) {
        const auto& [nx, ny, nz] = row.normal;
        const auto& [lx, ly, lz] = row.light;
        EXPECT_EQ(brightness(point(nx, ny, nz), point(lx, ly, lz)).raw(), row.brightness)
            << nx << ' ' << ny << ' ' << nz << " / " << lx << ' ' << ly << ' ' << lz;
    }
}

struct ShadeRow
{
    std::uint16_t colour;
    int brightness;
    int channel;
};

constexpr std::array shade_rows = {
    ShadeRow{1023, one, 255},          // 255.75
    ShadeRow{1023, one + 65'536, 255}, // 256.7, which the source's adder wraps to 0
    ShadeRow{1023, 2 * one, 255},      //
    ShadeRow{1023, 14'680'064, 223},   // 1023 / 4 * 7/8 = 223.8
    ShadeRow{512, one, 128},           //
    ShadeRow{4, one, 1},               //
    ShadeRow{3, one, 0},               // 0.75
    ShadeRow{0, one, 0},               //
    ShadeRow{1023, one / 8, 31},       // 31.97
};

TEST(Shading, ChannelsByHand)
{
    for (const ShadeRow& row : shade_rows) {
        const auto channels =
            shade({row.colour, 0, row.colour}, Coordinate::from_raw(row.brightness));
        EXPECT_EQ(channels[0], row.channel) << row.colour << " * " << row.brightness;
        EXPECT_EQ(channels[1], 0);
        EXPECT_EQ(channels[2], row.channel);
    }
}

} // namespace
} // namespace raymarch::engine::marcher
