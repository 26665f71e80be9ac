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

/// The device trees of boards have such names.
TEST(LineSpec, NamesMayHoldBlanks)
{
    const auto places = [](std::string_view text) { return parse_line_spec(text)->places; };
    EXPECT_EQ(places("GPIO 17"), std::vector{named("GPIO 17")});
    EXPECT_EQ(places("two  words and more"), std::vector{named("two  words and more")});
    EXPECT_EQ(places("P8_13 [gpio0_23]"), std::vector{named("P8_13 [gpio0_23]")});
    EXPECT_EQ(places("LED: D4"), std::vector{named("LED: D4")});
    EXPECT_EQ(places("a=b #1"), std::vector{named("a=b #1")});
    EXPECT_EQ(places("my chip:3"), std::vector{on_chip("my chip", 3)});
    EXPECT_EQ(places("GPIO 17|GPIO 18"), (std::vector{named("GPIO 17"), named("GPIO 18")}));
    EXPECT_EQ(places(" GPIO 17 | my chip:3 ,active-low"),
              (std::vector{named("GPIO 17"), on_chip("my chip", 3)}));
}

TEST(LineSpec, BetweenQuotesEachCharacterStandsForItself)
{
    const auto place = [](std::string_view text) {
        const auto spec = parse_line_spec(text);
        return spec ? spec->places.front() : named("refused");
    };
    EXPECT_EQ(place("'J8:3'"), named("J8:3")) << "not an offset";
    EXPECT_EQ(place("'none'"), named("none"));
    EXPECT_EQ(place("'cd,wp'"), named("cd,wp"));
    EXPECT_EQ(place("'a|b'"), named("a|b"));
    EXPECT_EQ(place("' x '"), named(" x "));
    EXPECT_EQ(place("'it''s'"), named("it's"));
    EXPECT_EQ(place("''''"), named("'"));
    EXPECT_EQ(place("it's"), named("it's")) << "a quote that is not the first";
    EXPECT_EQ(place("'bank, a':7"), on_chip("bank, a", 7));
    const auto spec = parse_line_spec("'cd,wp'|'a|b':1,active-low,pull-up");
    ASSERT_TRUE(spec);
    EXPECT_EQ(spec->places, (std::vector{named("cd,wp"), on_chip("a|b", 1)}));
    EXPECT_TRUE(spec->active_low);
    EXPECT_EQ(spec->pull, Pull::Up);
}

TEST(LineSpec, APlaceIsWrittenAsItIsRead)
{
    for (const std::string_view text :
         {"btn0", "GPIO 17", "J8:3", "led:red", "led:", "none", "cd,wp", "a|b", " x ", "x ", "'",
          "it's", "'quoted'", "''", ":3", ":", ",", "|", "chip:99999999999"})
        for (const LinePlace& place :
             {named(text), on_chip(text, 0), on_chip(text, 4'294'967'295)}) {
            const auto spec = parse_line_spec(to_string(place));
            ASSERT_TRUE(spec) << to_string(place);
            EXPECT_EQ(spec->places, std::vector{place}) << to_string(place);
        }
    EXPECT_EQ(to_string(named("GPIO 17")), "GPIO 17");
    EXPECT_EQ(to_string(named("J8:3")), "'J8:3'");
    EXPECT_EQ(to_string(named("it's")), "it's");
    EXPECT_EQ(to_string(on_chip("bank:a", 0)), "bank:a:0");
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

TEST(LineSpec, OtherTextsAreRefused)
{
    for (const std::string_view text : {"",
                                        ",",
                                        "x,",
                                        "x,,active-low",
                                        "x,loud",
                                        "x,Active-Low",
                                        "x,active-low,active-low",
                                        "x,pull-up,pull-down",
                                        "x,pull-up,pull-up",
                                        ":3",
                                        "x|",
                                        "|x",
                                        "x||y",
                                        " ",
                                        "x| ",
                                        " |x",
                                        "x, active-low",
                                        "x,active-low ",
                                        "x,active-low|y",
                                        "x,two words",
                                        "x\ty",
                                        "x\n",
                                        "'",
                                        "'x",
                                        "''",
                                        "''':3",
                                        "'':3",
                                        "'x'y",
                                        "'x':",
                                        "'x':y",
                                        "'x'|",
                                        "'x','y'",
                                        "'x\ty'"})
        EXPECT_FALSE(parse_line_spec(text)) << '"' << text << '"';
}

TEST(LineSpec, AnOffsetThatNoChipHasIsAName)
{
    EXPECT_EQ(parse_line_spec("chip:99999999999")->places.front(), named("chip:99999999999"));
    EXPECT_EQ(parse_line_spec("chip:-1")->places.front(), named("chip:-1"));
}

} // namespace
} // namespace raymarch::drivers
