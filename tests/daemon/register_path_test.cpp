// SPDX-License-Identifier: MIT
/// @file
/// Checks the exact order of the register accesses of each kind of update.
#include "daemon/register_path.hpp"

#include "protocol/accelerators.hpp"
#include "tests/fakes/recording_bus.hpp"

#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

namespace raymarch::daemon
{
namespace
{

using Accesses = std::vector<std::string>;

const Accesses probe_extended = {"R 20", "W 48=A5A55A5A", "R 48", "W 48=5A5AA5A5", "R 48", "R 28"};
const Accesses read_all = {"R 00", "R 04", "R 08", "R 0C", "R 10", "R 14", "R 18", "R 1C"};
const Accesses write_ones = {"W 00=00000001", "W 04=00000001", "W 08=00000001", "W 0C=00000001",
                             "W 10=00000001", "W 14=00000001", "W 18=00000001", "W 1C=00000001"};
const Accesses look_at_status = {"R 38"};
const Accesses commit = {"W 34=00000001"};

Accesses operator+(Accesses first, const Accesses& second)
{
    first.insert(first.end(), second.begin(), second.end());
    return first;
}

protocol::Words all(std::uint32_t word)
{
    protocol::Words words{};
    for (std::size_t i = 0; i < protocol::marcher::description.word_count; ++i)
        words[i] = word;
    return words;
}

protocol::Words with(protocol::Words words, std::size_t index, std::uint32_t word)
{
    words[index] = word;
    return words;
}

Result<RegisterPath> probe(test::RecordingBus& bus)
{
    return RegisterPath::probe(bus, protocol::marcher::description);
}

/// A path after probe(), for a block with or without extended registers.
struct Block
{
    explicit Block(bool extended)
    {
        if (extended)
            bus.memory[0x20] = 0x524D'4152;
        path = *probe(bus);
        static_cast<void>(bus.take_accesses());
    }
    test::RecordingBus bus;
    Result<RegisterPath> path = fail(plain_error(ErrorKind::Unavailable, ""));
};

TEST(Probe, APlainBlockIsOnlyAskedForItsId)
{
    test::RecordingBus bus;
    const auto path = probe(bus);
    ASSERT_TRUE(path);
    EXPECT_FALSE(path->extended());
    EXPECT_EQ(path->accelerator().name, "marcher");
    EXPECT_EQ(path->frames(), 0U);
    EXPECT_EQ(path->status(), 0U);
    EXPECT_EQ(bus.take_accesses(), Accesses{"R 20"});
}

TEST(Probe, AnExtendedBlockIsTestedAndEnabledInShadowMode)
{
    test::RecordingBus bus;
    bus.memory[0x20] = 0x524D'4152;
    const auto path = probe(bus);
    ASSERT_TRUE(path);
    EXPECT_TRUE(path->extended());
    EXPECT_EQ(bus.take_accesses(), probe_extended + Accesses{"W 30=00000005"});
}

TEST(Probe, TheInterruptIsEnabledWhereThereIsALine)
{
    test::RecordingBus bus;
    bus.memory[0x20] = 0x524D'4152;
    bus.interrupt = 0;
    ASSERT_TRUE(probe(bus));
    EXPECT_EQ(bus.take_accesses(), probe_extended + Accesses{"W 30=00000007"});
}

TEST(Probe, ABitOfScratchThatIsStuckIsRefused)
{
    for (const std::uint32_t stuck : {0x8000'0000U, 0x0000'0001U, 0x4000'0000U}) {
        test::RecordingBus bus;
        bus.memory[0x20] = 0x524D'4152;
        bus.stuck_at_zero[0x48] = stuck;
        const auto path = probe(bus);
        ASSERT_FALSE(path) << stuck;
        EXPECT_EQ(path.error().kind, ErrorKind::Unavailable);
        EXPECT_NE(path.error().message.find("SCRATCH"), std::string::npos);
        for (const std::string& access : bus.take_accesses())
            EXPECT_FALSE(access.starts_with("W 30")) << "enabled all the same";
    }
}

TEST(Probe, AnUnknownKindIsRefused)
{
    test::RecordingBus bus;
    bus.memory[0x20] = 0x524D'4152;
    bus.memory[0x28] = 0xFE04'0000;
    const auto path = probe(bus);
    ASSERT_FALSE(path);
    EXPECT_NE(path.error().message.find("254"), std::string::npos) << path.error().message;
    EXPECT_EQ(bus.take_accesses(), probe_extended); // the block is not enabled
}

TEST(RegisterPath, TheFirstUpdateWritesEveryWord)
{
    Block extended(true);
    EXPECT_EQ(extended.path->apply(all(1)), Applied::Written);
    EXPECT_EQ(extended.bus.take_accesses(), look_at_status + write_ones + read_all + commit);
    Block plain(false);
    EXPECT_EQ(plain.path->apply(all(1)), Applied::Written);
    EXPECT_EQ(plain.bus.take_accesses(), write_ones + read_all);
}

TEST(RegisterPath, OnlyWhatChangedIsWritten)
{
    Block block(true);
    ASSERT_EQ(block.path->apply(all(1)), Applied::Written);
    static_cast<void>(block.bus.take_accesses());
    EXPECT_EQ(block.path->apply(with(all(1), 3, 0xABCD)), Applied::Written);
    EXPECT_EQ(block.bus.take_accesses(),
              look_at_status + Accesses{"W 0C=0000ABCD"} + read_all + commit);
    EXPECT_EQ(block.path->apply(with(with(all(1), 0, 5), 7, 6)), Applied::Written);
    EXPECT_EQ(block.bus.take_accesses(),
              (look_at_status + Accesses{"W 00=00000005", "W 0C=00000001", "W 1C=00000006"} +
               read_all + commit));
}

TEST(RegisterPath, NothingChangedIsOnlyReadBack)
{
    Block block(true);
    ASSERT_EQ(block.path->apply(all(1)), Applied::Written);
    static_cast<void>(block.bus.take_accesses());
    EXPECT_EQ(block.path->apply(all(1)), Applied::Written);
    EXPECT_EQ(block.bus.take_accesses(), look_at_status + read_all);
}

TEST(RegisterPath, ABadReadBackRestoresAndDoesNotCommit)
{
    Block block(true);
    ASSERT_EQ(block.path->apply(all(1)), Applied::Written);
    static_cast<void>(block.bus.take_accesses());
    block.bus.stuck_at_zero[0x08] = 0x8;
    EXPECT_EQ(block.path->apply(with(all(1), 2, 0xF)), Applied::Failed);
    EXPECT_EQ(block.bus.take_accesses(),
              (look_at_status + Accesses{"W 08=0000000F", "R 00", "R 04", "R 08"} + write_ones +
               Accesses{"W 30=00000005"}));
    EXPECT_EQ(block.bus.memory[0x08], 1U);
}

TEST(RegisterPath, AfterABadReadBackEveryWordIsWritten)
{
    Block block(true);
    ASSERT_EQ(block.path->apply(all(1)), Applied::Written);
    block.bus.stuck_at_zero[0x00] = 0x2;
    ASSERT_EQ(block.path->apply(all(2)), Applied::Failed);
    block.bus.stuck_at_zero.clear();
    static_cast<void>(block.bus.take_accesses());
    EXPECT_EQ(block.path->apply(all(1)), Applied::Written);
    EXPECT_EQ(block.bus.take_accesses(), look_at_status + write_ones + read_all + commit);
}

/// A reset clears the words and CONTROL of the block. After two updates it draws again.
TEST(RegisterPath, LogicThatWasResetIsEnabledAgain)
{
    Block block(true);
    ASSERT_EQ(block.path->apply(all(1)), Applied::Written);
    for (std::uint16_t offset = 0; offset < 0x20; offset += 4)
        block.bus.memory[offset] = 0;
    const std::uint32_t enabled = std::exchange(block.bus.memory[0x30], 0U);
    EXPECT_EQ(block.path->apply(with(all(1), 2, 0xF)), Applied::Failed);
    EXPECT_EQ(block.bus.memory[0x30], enabled);
    EXPECT_EQ(block.path->apply(with(all(1), 2, 0xF)), Applied::Written);
    EXPECT_EQ(block.bus.memory[0x08], 0xFU);
}

TEST(RegisterPath, WithoutAnEarlierStateThereIsNothingToRestore)
{
    Block block(false);
    block.bus.stuck_at_zero[0x1C] = 1;
    EXPECT_EQ(block.path->apply(all(1)), Applied::Failed);
    EXPECT_EQ(block.bus.take_accesses(), write_ones + read_all);
}

TEST(RegisterPath, AWindowThatWentAwayIsAFailure)
{
    Block block(false);
    block.bus.is_lost = true; // even if the read values are right
    EXPECT_EQ(block.path->apply(all(0)), Applied::Failed);
}

TEST(RegisterPath, NothingIsWrittenWhileACommitIsPending)
{
    Block block(true);
    ASSERT_EQ(block.path->apply(all(1)), Applied::Written);
    static_cast<void>(block.bus.take_accesses());
    block.bus.memory[0x38] = protocol::status::commit_pending;
    EXPECT_EQ(block.path->apply(with(all(1), 0, 2)), Applied::Deferred);
    EXPECT_EQ(block.path->apply(with(all(1), 1, 3)), Applied::Deferred);
    EXPECT_EQ(block.path->retry(), Applied::Deferred);
    EXPECT_TRUE(block.path->deferred());
    EXPECT_EQ(block.bus.take_accesses(), look_at_status + look_at_status + look_at_status);

    block.bus.memory[0x38] = 0;
    EXPECT_EQ(block.path->retry(), Applied::Written); // the newer update
    EXPECT_EQ(block.bus.take_accesses(),
              look_at_status + Accesses{"W 04=00000003"} + read_all + commit);
    EXPECT_FALSE(block.path->deferred());
}

TEST(RegisterPath, ANewerUpdateTakesThePlaceOfADeferredOne)
{
    Block block(true);
    ASSERT_EQ(block.path->apply(all(1)), Applied::Written);
    block.bus.memory[0x38] = protocol::status::commit_pending;
    ASSERT_EQ(block.path->apply(all(2)), Applied::Deferred);
    block.bus.memory[0x38] = 0;
    static_cast<void>(block.bus.take_accesses());
    EXPECT_EQ(block.path->apply(with(all(1), 4, 9)), Applied::Written);
    EXPECT_EQ(block.bus.take_accesses(),
              look_at_status + Accesses{"W 10=00000009"} + read_all + commit);
    EXPECT_FALSE(block.path->deferred());
}

TEST(RegisterPath, ARetryWithoutAnythingDeferredTouchesNothing)
{
    Block block(true);
    EXPECT_EQ(block.path->retry(), Applied::Written);
    EXPECT_EQ(block.bus.take_accesses(), Accesses{});
}

TEST(RegisterPath, OtherStatusBitsDoNotDefer)
{
    Block block(true);
    block.bus.memory[0x38] =
        protocol::status::busy | protocol::status::frame_done | protocol::status::fault;
    EXPECT_EQ(block.path->apply(all(1)), Applied::Written);
}

TEST(RegisterPath, FramesAreAcknowledgedAndCounted)
{
    Block block(true);
    block.bus.memory[0x3C] = 42;
    block.path->acknowledge_frame();
    EXPECT_EQ(block.path->frames(), 42U);
    EXPECT_EQ(block.bus.take_accesses(), (Accesses{"W 38=00000004", "R 3C"}));
    Block plain(false);
    plain.path->acknowledge_frame();
    EXPECT_EQ(plain.bus.take_accesses(), Accesses{});
}

} // namespace
} // namespace raymarch::daemon
