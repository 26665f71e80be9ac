// SPDX-License-Identifier: MIT
#include "drivers/debouncer.hpp"

#include <gtest/gtest.h>

#include <optional>
#include <vector>

namespace raymarch::drivers
{
namespace
{

using std::chrono::milliseconds;
constexpr milliseconds settle{10};
constexpr std::optional<bool> nothing;

TEST(Debouncer, APressThatBouncesCountsOnce)
{
    Debouncer button(settle, false);
    EXPECT_EQ(button.edge(true, milliseconds{1000}), nothing);
    EXPECT_EQ(button.edge(false, milliseconds{1002}), nothing);
    EXPECT_EQ(button.edge(true, milliseconds{1003}), nothing);
    EXPECT_EQ(button.sample(true), true);
    EXPECT_TRUE(button.level());
    EXPECT_EQ(button.sample(true), nothing);
}

TEST(Debouncer, AReleaseThatBouncesCountsOnce)
{
    Debouncer button(settle, true);
    EXPECT_EQ(button.edge(false, milliseconds{50}), nothing);
    EXPECT_EQ(button.edge(true, milliseconds{51}), nothing);
    EXPECT_EQ(button.edge(false, milliseconds{52}), nothing);
    EXPECT_EQ(button.sample(false), false);
}

TEST(Debouncer, AGlitchCountsForNothing)
{
    Debouncer button(settle, false);
    EXPECT_EQ(button.edge(true, milliseconds{1000}), nothing);
    EXPECT_EQ(button.edge(false, milliseconds{1009}), nothing);
    EXPECT_EQ(button.sample(false), nothing);
    EXPECT_FALSE(button.level());
}

/// The loop was busy, so press and release are read together. Their timestamps separate them.
TEST(Debouncer, APressThatIsReadLateIsNotLost)
{
    Debouncer button(settle, false);
    EXPECT_EQ(button.edge(true, milliseconds{1000}), nothing);
    EXPECT_EQ(button.edge(false, milliseconds{1010}), true) << "it had lasted just long enough";
    EXPECT_EQ(button.edge(true, milliseconds{1300}), false);
    EXPECT_EQ(button.sample(true), true);
}

TEST(Debouncer, EdgesThatTheSystemDroppedAreMadeUpFor)
{
    Debouncer button(settle, false);
    EXPECT_EQ(button.edge(true, milliseconds{1000}), nothing);
    EXPECT_EQ(button.sample(false), nothing) << "the release was never reported";
    EXPECT_EQ(button.sample(true), true) << "and now the press was not";
}

TEST(Debouncer, TwoEdgesOfOneDirectionAreTaken)
{
    Debouncer button(settle, false);
    EXPECT_EQ(button.edge(true, milliseconds{1000}), nothing);
    EXPECT_EQ(button.edge(true, milliseconds{1020}), true);
    EXPECT_EQ(button.sample(true), nothing);
}

TEST(Debouncer, ATimeThatGoesBackHasNotLasted)
{
    Debouncer button(settle, false);
    EXPECT_EQ(button.edge(true, milliseconds{1000}), nothing);
    EXPECT_EQ(button.edge(false, milliseconds{5}), nothing);
    EXPECT_EQ(button.sample(false), nothing);
}

TEST(Debouncer, WithoutASettlingTimeEveryEdgeCounts)
{
    Debouncer button(milliseconds{0}, false);
    std::vector<bool> levels;
    for (int i = 1; i <= 4; ++i)
        if (const auto level = button.edge(i % 2 == 1, milliseconds{i}))
            levels.push_back(*level);
    EXPECT_EQ(levels,
              (std::vector<bool>{true, false, true})); // the next edge accepts the last level
}

} // namespace
} // namespace raymarch::drivers
