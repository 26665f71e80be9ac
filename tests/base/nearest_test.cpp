// SPDX-License-Identifier: MIT
#include "base/nearest.hpp"

#include <gtest/gtest.h>

#include <array>
#include <string>

namespace raymarch
{
namespace
{

struct Distance
{
    std::string_view one;
    std::string_view other;
    std::size_t distance;
};
constexpr std::array distances = {
    Distance{"", "", 0},
    Distance{"", "abc", 3},
    Distance{"render", "render", 0},
    Distance{"Render", "rENDER", 0},
    Distance{"rendr", "render", 1},
    Distance{"rrender", "render", 1},
    Distance{"renber", "render", 1},
    Distance{"redner", "render", 1},
    Distance{"statsu", "status", 1},
    Distance{"kitten", "sitting", 3},
    Distance{"ab", "ba", 1},
    Distance{"abc", "cab", 2},
    Distance{"S1.X", "S2.X", 1},
};

TEST(EditDistance, CountsSlipsInBothDirections)
{
    for (const Distance& row : distances) {
        EXPECT_EQ(edit_distance(row.one, row.other), row.distance) << row.one << ' ' << row.other;
        EXPECT_EQ(edit_distance(row.other, row.one), row.distance) << row.other << ' ' << row.one;
    }
}

constexpr std::array<std::string_view, 7> words = {"encode", "decode", "render",         "film",
                                                   "FX",     "X",      "menger_crossing"};
struct Meant
{
    std::string_view word;
    std::string_view nearest; ///< empty: none
};
constexpr std::array meant = {
    Meant{"rendr", "render"},
    Meant{"redner", "render"},
    Meant{"RENDER", "render"},
    Meant{"renderer", "render"},
    Meant{"fim", "film"},
    Meant{"films", "film"},
    Meant{"flm", "film"},
    Meant{"endcode", "encode"},
    Meant{"mode", ""},         // three slips
    Meant{"recode", "decode"}, // one slip from it, two from encode
    Meant{"mengercrossing", "menger_crossing"},
    Meant{"menger_corsing", "menger_crossing"},
    Meant{"mengrcrosing", ""}, // three slips, though of fifteen letters
    Meant{"frobnicate", ""},
    Meant{"fi", ""}, // two of four
    Meant{"FY", ""}, // one of two
    Meant{"Y", ""},
    Meant{"", ""},
};

TEST(Nearest, IsAtMostTwoSlipsAndAThirdAway)
{
    for (const Meant& row : meant) {
        const auto found = nearest(row.word, words);
        EXPECT_EQ(found.value_or(""), row.nearest) << row.word;
        EXPECT_EQ(did_you_mean(row.word, words),
                  row.nearest.empty() ? "" : "; did you mean '" + std::string(row.nearest) + "'?");
    }
}

TEST(Nearest, OfSeveralIsTheFirst)
{
    constexpr std::array<std::string_view, 3> alike = {"cube", "tube", "lube"};
    EXPECT_EQ(nearest("rube", alike), "cube");
    EXPECT_EQ(nearest("tub", alike), "tube");
    EXPECT_FALSE(nearest("cube", {}));
}

TEST(Nearest, ALongWordIsNotLookedAt)
{
    EXPECT_FALSE(nearest(std::string(1'000'000, 'e'), words));
}

} // namespace
} // namespace raymarch
