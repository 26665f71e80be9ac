// SPDX-License-Identifier: MIT
#include "protocol/groups.hpp"

#include "tests/fakes/descriptions.hpp"
#include "tests/protocol/accelerator.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <string_view>

namespace raymarch::protocol
{
namespace
{

class Groups : public test::EveryAccelerator
{};
INSTANTIATE_TEST_SUITE_P(Accelerators, Groups, testing::ValuesIn(accelerators),
                         test::accelerator_name);

TEST_P(Groups, AreFoundInAnyCase)
{
    for (const std::string_view group : groups()) {
        EXPECT_EQ(find_group(accelerator, group), group);
        std::string upper(group);
        std::ranges::transform(upper, upper.begin(), to_upper);
        EXPECT_EQ(find_group(accelerator, upper), group);
    }
    EXPECT_FALSE(find_group(accelerator, ""));
    EXPECT_FALSE(find_group(accelerator, "nothing"));
}

TEST_P(Groups, AreResetOneByOneOrAll)
{
    auto random = test::seeded_random();
    const State changed = test::random_state(accelerator, random);
    for (const std::string_view group : groups()) {
        State state = changed;
        reset(accelerator, group, state);
        for (std::size_t p = 0; p < table.size(); ++p)
            EXPECT_EQ(state.codes[p],
                      table[p].group == group ? table[p].initial_code : changed.codes[p])
                << table[p].key << " by " << group;
    }
    State state = changed;
    reset(accelerator, "", state);
    EXPECT_EQ(state, initial_state(accelerator));
}

TEST(MarcherGroups, AreCalledAsTheContractSays)
{
    EXPECT_EQ(find_group(accelerator, "CAMERA"), "camera");
    EXPECT_EQ(find_group(accelerator, "Colour"), "colour");
    EXPECT_FALSE(find_group(accelerator, ""));
    EXPECT_FALSE(find_group(accelerator, "color"));
    EXPECT_FALSE(find_group(accelerator, "FX"));
}

} // namespace
} // namespace raymarch::protocol
