// SPDX-License-Identifier: MIT
#include "drivers/line_spec.hpp"

#include <gtest/gtest.h>

#include <array>
#include <string_view>

namespace raymarch::drivers
{
namespace
{

LinePlace named(std::string_view name)
{
    return {.name = std::string(name), .chip = {}};
}
LinePlace on_chip(std::string_view chip, unsigned offset)
{
    return {.name = {}, .chip = std::string(chip), .offset = offset};
}

TEST(LineSpec, PlacesAreNamesOrChipsWithOffsets)
{
    const auto place = [](std::string_view text) { return parse_line_spec(text)->places.front(); };
    EXPECT_EQ(place("btn0"), named("btn0"));
    EXPECT_EQ(place("41200000.gpio:3"), on_chip("41200000.gpio", 3));
    EXPECT_EQ(place("/dev/gpiochip0:17"), on_chip("/dev/gpiochip0", 17));
    EXPECT_EQ(place("bank:a:0"), on_chip("bank:a", 0));
    EXPECT_EQ(place("led:red"), named("led:red")) << "no number behind the colon";
    EXPECT_EQ(place("led:"), named("led:"));
    for (const std::string_view text : {"btn0", "pynq-z1:3", "/dev/gpiochip0:17"})
        EXPECT_EQ(to_string(place(text)), text);
}

TEST(LineSpec, PlacesAreTriedInTheirOrder)
{
    const auto spec = parse_line_spec("btn0|pynq-z1:0|/dev/gpiochip1:2,active-low");
    ASSERT_TRUE(spec);
    EXPECT_EQ(spec->places,
              (std::vector{named("btn0"), on_chip("pynq-z1", 0), on_chip("/dev/gpiochip1", 2)}));
    EXPECT_TRUE(spec->active_low);
}

struct WiringRow
{
    std::string_view text;
    bool active_low;
    Pull pull;
};
constexpr std::array wirings = {
    WiringRow{"x", false, Pull::AsIs},
    WiringRow{"x,active-low", true, Pull::AsIs},
    WiringRow{"x,pull-up", false, Pull::Up},
    WiringRow{"x,pull-down", false, Pull::Down},
    WiringRow{"x,no-pull", false, Pull::None},
    WiringRow{"x,pull-up,active-low", true, Pull::Up},
    WiringRow{"x,active-low,pull-up", true, Pull::Up},
};

TEST(LineSpec, Wirings)
{
    for (const WiringRow& row : wirings) {
        const auto spec = parse_line_spec(row.text);
        ASSERT_TRUE(spec) << row.text;
        EXPECT_EQ(spec->active_low, row.active_low) << row.text;
        EXPECT_EQ(spec->pull, row.pull) << row.text;
    }
}

TEST(LineSpec, OtherTextsAreNone)
{
    for (const std::string_view text :
         {"", ",", "x,", "x,,active-low", "x,loud", "x,Active-Low", "x,active-low,active-low",
          "x,pull-up,pull-down", "x,pull-up,pull-up", ":3", "x|", "|x", "x||y", "two words",
          "x, active-low", "x,active-low|y"})
        EXPECT_FALSE(parse_line_spec(text)) << '"' << text << '"';
}

TEST(LineSpec, AnOffsetThatNoChipHasIsAName)
{
    EXPECT_EQ(parse_line_spec("chip:99999999999")->places.front(), named("chip:99999999999"));
    EXPECT_EQ(parse_line_spec("chip:-1")->places.front(), named("chip:-1"));
}

} // namespace
} // namespace raymarch::drivers
