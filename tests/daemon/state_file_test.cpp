// SPDX-License-Identifier: MIT
#include "daemon/state_file.hpp"

#include "base/crc32.hpp"
#include "motion/random_values.hpp"
#include "protocol/accelerators.hpp"
#include "tests/fakes/descriptions.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <string>

namespace raymarch::daemon
{
namespace
{

constexpr const protocol::Accelerator& accelerator = protocol::marcher::description;

protocol::State initial()
{
    return protocol::initial_state(accelerator);
}

/// Only the accelerator of this test has a state.
PersistedStates only(const PersistedState& state)
{
    PersistedStates states;
    states.of(accelerator) = state;
    return states;
}

const std::string default_frame =
    "FX=0,FY=0,FZ=0.99999,RX=0.99999,RY=0,RZ=0,UX=0,UY=0.99999,UZ=0,ZM=3,"
    "LX=3,LY=2,LZ=5,R=0.999,G=0.999,B=0.999,OBJ=sphere";

/// Returns `body` between the header and a valid checksum.
std::string checked(const std::string& body)
{
    const std::string text = "raymarch-state 1\n" + body;
    return text + fmt::format("crc32 {:08X}\n", crc32(text));
}

TEST(StateFile, IsText)
{
    EXPECT_EQ(format_state_file(only({.last = initial(), .saved = std::nullopt})),
              checked("last marcher " + default_frame + "\n"));
    EXPECT_EQ(format_state_file({}), checked(""));
}

TEST(StateFile, ComesBack)
{
    auto random = test::seeded_random();
    for (int i = 0; i < 300; ++i) {
        PersistedState state;
        if (test::pick(random, 0, 3) > 0)
            motion::randomise(accelerator, "", random, state.last.emplace(initial()));
        if (test::pick(random, 0, 3) > 0)
            motion::randomise(accelerator, "", random, state.saved.emplace(initial()));
        const auto back = parse_state_file(format_state_file(only(state)));
        ASSERT_TRUE(back) << back.error().message;
        ASSERT_EQ(*back, only(state));
    }
}

std::string whole_file()
{
    return format_state_file(only({.last = initial(), .saved = initial()}));
}

TEST(StateFile, IsRefusedWhenItIsCutAnywhere)
{
    const std::string text = whole_file();
    for (std::size_t size = 0; size < text.size(); ++size) {
        const auto result = parse_state_file(text.substr(0, size));
        ASSERT_FALSE(result) << size << " bytes";
        EXPECT_EQ(result.error().kind, ErrorKind::BadData);
    }
    EXPECT_TRUE(parse_state_file(text));
}

TEST(StateFile, IsRefusedWhenAnyByteIsWrong)
{
    const std::string text = whole_file();
    for (std::size_t at = 0; at < text.size(); ++at) {
        std::string other = text;
        other[at] = static_cast<char>(other[at] ^ 1);
        EXPECT_FALSE(parse_state_file(other)) << "byte " << at;
    }
    EXPECT_FALSE(parse_state_file(text + "\n"));
    EXPECT_FALSE(parse_state_file(text + text));
    EXPECT_FALSE(parse_state_file(std::string(100, '\0')));
}

TEST(StateFile, AnotherVersionIsRefused)
{
    const std::string text = "raymarch-state 2\n";
    const auto result = parse_state_file(text + fmt::format("crc32 {:08X}\n", crc32(text)));
    ASSERT_FALSE(result);
    EXPECT_NE(result.error().message.find("version"), std::string::npos);
}

TEST(StateFile, StatesOfAnUnknownAcceleratorAreKept)
{
    const std::string unknown = "last unheard_of CX=0\nsaved unheard_of CX=1,CY=2\n";
    const auto result =
        parse_state_file(checked(unknown + "saved marcher " + default_frame + "\n"));
    ASSERT_TRUE(result) << result.error().message;
    EXPECT_EQ(result->others, unknown);
    const auto back = parse_state_file(format_state_file(*result));
    ASSERT_TRUE(back) << back.error().message;
    EXPECT_EQ(*back, *result);
}

TEST(StateFile, StatesBesideThoseOfAnUnknownAcceleratorAreRead)
{
    auto result =
        parse_state_file(checked("last unheard_of CX=0\nsaved marcher " + default_frame + "\n"));
    ASSERT_TRUE(result) << result.error().message;
    EXPECT_FALSE(result->of(accelerator).last);
    EXPECT_EQ(result->of(accelerator).saved, initial());
}

TEST(StateFile, AStateThatIsNoFrameIsRefused)
{
    EXPECT_FALSE(parse_state_file(checked("last marcher ZM=11\n")));
    EXPECT_FALSE(parse_state_file(checked("last marcher ZM=1\n")));
    EXPECT_FALSE(parse_state_file(checked("last marcher\n")));
}

TEST(StateFile, HoldsAllAcceleratorsAtOnce)
{
    auto random = test::seeded_random();
    for (int i = 0; i < 50; ++i) {
        PersistedStates states;
        for (const protocol::Accelerator* each : protocol::accelerators) {
            if (test::pick(random, 0, 3) > 0)
                states.of(*each).last = test::random_state(*each, random);
            if (test::pick(random, 0, 3) > 0)
                states.of(*each).saved = test::random_state(*each, random);
        }
        const auto back = parse_state_file(format_state_file(states));
        ASSERT_TRUE(back) << back.error().message;
        ASSERT_EQ(*back, states);
    }
}

class EveryStateFile : public test::EveryAccelerator
{};
INSTANTIATE_TEST_SUITE_P(Accelerators, EveryStateFile, testing::ValuesIn(protocol::accelerators),
                         test::accelerator_name);

TEST_P(EveryStateFile, KeepsTheStateOfOneAlone)
{
    auto random = test::seeded_random();
    PersistedStates states;
    states.of(accelerator) = {.last = test::random_state(accelerator, random),
                              .saved = protocol::initial_state(accelerator)};
    const std::string text = format_state_file(states);
    EXPECT_NE(text.find("last " + std::string(accelerator.name) + " "), std::string::npos);
    auto back = parse_state_file(text);
    ASSERT_TRUE(back) << back.error().message;
    EXPECT_EQ(*back, states);
}

TEST_P(EveryStateFile, RowsThatItDoesNotNameAreTheDefaults)
{
    const std::string name(accelerator.name);
    auto back =
        parse_state_file(checked("last " + name + " " + test::default_frame(accelerator) + "\n"));
    ASSERT_TRUE(back) << back.error().message;
    EXPECT_EQ(back->of(accelerator).last, protocol::initial_state(accelerator));
    EXPECT_FALSE(back->of(accelerator).saved);
}

TEST_P(EveryStateFile, AStateThatIsNoFrameIsRefused)
{
    const std::string name(accelerator.name);
    for (std::size_t i = 0; i < table.size(); ++i) {
        if (!accelerator.frame[i])
            continue;
        const std::string text = test::default_frame(accelerator, i);
        EXPECT_FALSE(parse_state_file(checked("last " + name + " " + text + "\n")))
            << "without " << table[i].key;
    }
}

} // namespace
} // namespace raymarch::daemon
