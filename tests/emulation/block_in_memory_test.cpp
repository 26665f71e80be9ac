// SPDX-License-Identifier: MIT
#include "emulation/block_in_memory.hpp"

#include "protocol/accelerators.hpp"
#include "protocol/registers.hpp"

#include <gtest/gtest.h>

#include <array>
#include <utility>
#include <vector>

namespace raymarch::emulation
{
namespace
{

using protocol::Register;
namespace status = protocol::status;

const protocol::Accelerator& accelerator = protocol::marcher::description;

/// A register bus that stores and records all writes; the test can also set its registers.
class ScriptedBlock final : public drivers::RegisterBus
{
  public:
    std::uint32_t read(drivers::RegOffset at) noexcept override { return words[at.bytes / 4]; }
    void write(drivers::RegOffset at, std::uint32_t word) noexcept override
    {
        writes.emplace_back(at.bytes, word);
        words[at.bytes / 4] = word;
    }
    int interrupt_fd() const noexcept override { return -1; }
    void arm_interrupt() noexcept override { ++armed; }
    Result<std::uint32_t> take_interrupt() override { return 0; }
    bool lost() const noexcept override { return false; }

    std::array<std::uint32_t, protocol::register_page_bytes / 4> words{};
    std::vector<std::pair<unsigned, std::uint32_t>> writes;
    int armed = 0;
};

class Memory : public testing::Test
{
  protected:
    std::uint32_t& at(Register reg) { return page[static_cast<std::size_t>(reg) / 4]; }
    std::uint32_t& of_block(Register reg) { return block.words[static_cast<std::size_t>(reg) / 4]; }

    ScriptedBlock block;
    std::vector<std::uint32_t> page =
        std::vector<std::uint32_t>(protocol::register_page_bytes / 4, 0xDEADBEEF);
};

using Writes = std::vector<std::pair<unsigned, std::uint32_t>>;

TEST_F(Memory, ShowsWhatTheBlockSaysAndForgetsWhatWasThere)
{
    of_block(Register::Id) = protocol::id_value;
    of_block(Register::Geometry) = 0x00080006;
    const BlockInMemory shown(page, block, accelerator);
    EXPECT_EQ(at(Register::Id), protocol::id_value);
    EXPECT_EQ(at(Register::Geometry), 0x00080006U);
    EXPECT_EQ(at(Register::Scratch), 0U);
    EXPECT_EQ(page[0], 0U);
    EXPECT_EQ(block.writes, Writes{});
}

TEST_F(Memory, ShowsFramesAsTheyAreCounted)
{
    BlockInMemory shown(page, block, accelerator);
    of_block(Register::Frames) = 7;
    of_block(Register::Cycles) = 1234;
    EXPECT_FALSE(shown.step());
    EXPECT_EQ(at(Register::Frames), 7U);
    EXPECT_EQ(at(Register::Cycles), 1234U);
    EXPECT_EQ(block.writes, Writes{});
}

TEST_F(Memory, GivesTheWordsBeforeTheCommitAndTakesTheCommitBack)
{
    BlockInMemory shown(page, block, accelerator);
    page[1] = 0x11;
    page[7] = 0x77;
    at(Register::Commit) = 1;
    EXPECT_TRUE(shown.step());
    EXPECT_EQ(block.writes, (Writes{{0x04, 0x11}, {0x1C, 0x77}, {0x34, 1}}));
    EXPECT_EQ(at(Register::Commit), 0U);
    block.writes.clear();
    EXPECT_FALSE(shown.step());
    EXPECT_EQ(block.writes, Writes{});
}

TEST_F(Memory, GivesControlOnceAndShowsWhatBecameOfIt)
{
    BlockInMemory shown(page, block, accelerator);
    at(Register::Control) = 5;
    static_cast<void>(shown.step());
    static_cast<void>(shown.step());
    EXPECT_EQ(block.writes, (Writes{{0x30, 5}}));
    EXPECT_EQ(at(Register::Control), 5U);
}

TEST_F(Memory, SeesThatFrameDoneIsClearedThoughTheWordStaysTheSame)
{
    of_block(Register::Status) = status::frame_done;
    BlockInMemory shown(page, block, accelerator);
    static_cast<void>(shown.step());
    EXPECT_EQ(at(Register::Status) & 0xF, status::frame_done);
    EXPECT_EQ(block.writes, Writes{});

    at(Register::Status) = status::frame_done;
    static_cast<void>(shown.step());
    EXPECT_EQ(block.writes, (Writes{{0x38, status::frame_done}}));
    EXPECT_EQ(block.armed, 1);
}

} // namespace
} // namespace raymarch::emulation
