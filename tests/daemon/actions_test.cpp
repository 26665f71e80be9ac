// SPDX-License-Identifier: MIT
#include "daemon/actions.hpp"

#include "daemon/config.hpp"

#include <gtest/gtest.h>

#include <set>
#include <string_view>

namespace raymarch::daemon
{
namespace
{

TEST(Actions, EachHasANameAMeaningAndALineOfItsOwn)
{
    const Config config = default_config();
    ASSERT_EQ(config.gpio.lines.size(), actions().size());
    std::set<std::string_view> names;
    for (std::size_t i = 0; i < actions().size(); ++i) {
        const Action& action = actions()[i];
        EXPECT_TRUE(names.insert(action.name).second) << action.name;
        EXPECT_FALSE(action.meaning.empty() || action.place.empty()) << action.name;
        ASSERT_TRUE(config.gpio.lines[i]) << action.name;
        EXPECT_EQ(to_string(config.gpio.lines[i]->places.front()), action.line);
    }
    EXPECT_TRUE(validate(config));
}

TEST(Actions, TheHardwareAtFaultAndAFrameRefusedLightTheSameLed)
{
    const auto lit = [](const PanelStatus& now) {
        for (const Action& action : actions())
            if (action.name == "refused")
                return std::get<Show>(action.behaviour)(now);
        return false;
    };
    EXPECT_FALSE(lit({.hardware = {.fault = false, .running = true}}));
    EXPECT_TRUE(lit({.refused = true, .hardware = {.fault = false, .running = true}}));
    EXPECT_TRUE(lit({.hardware = {.fault = true, .running = true}}));
}

} // namespace
} // namespace raymarch::daemon
