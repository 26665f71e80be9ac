// SPDX-License-Identifier: MIT
/// @file
/// Every wait is for the block's interrupt or its frame sink, never for a fixed time.
#include "emulation/emulated_block.hpp"

#include "engine/draw.hpp"
#include "engine/models.hpp"
#include "engine/progressive.hpp"
#include "protocol/registers.hpp"
#include "tests/fakes/waiting.hpp"

#include <gtest/gtest.h>

#include <condition_variable>
#include <memory>
#include <mutex>
#include <vector>

namespace raymarch::emulation
{
namespace
{

using protocol::Register;
namespace control = protocol::control;
namespace status = protocol::status;

constexpr protocol::PictureSize size{8, 6};
const engine::Model& model = engine::models[0];

drivers::RegOffset at(Register reg)
{
    return {static_cast<std::uint16_t>(reg)};
}

/// Receives frames. It can hold the worker in a frame, so that a test sees the block while it
/// draws.
class Screen
{
  public:
    void take(const engine::Image& image)
    {
        std::unique_lock lock(mutex_);
        frames_.push_back(image.rgb);
        changed_.notify_all();
        changed_.wait(lock, [this] { return !held_; });
    }
    void hold() { set_held(true); }
    void let_go() { set_held(false); }
    /// Waits until `count` frames have come. Returns the last one.
    std::vector<std::uint8_t> frame(std::size_t count)
    {
        std::unique_lock lock(mutex_);
        const bool came = changed_.wait_for(lock, std::chrono::milliseconds(test::patience_ms),
                                            [&] { return frames_.size() >= count; });
        EXPECT_TRUE(came) << "frame " << count << " did not come";
        return came ? frames_[count - 1] : std::vector<std::uint8_t>{};
    }

  private:
    void set_held(bool held)
    {
        const std::scoped_lock lock(mutex_);
        held_ = held;
        changed_.notify_all();
    }
    std::mutex mutex_;
    std::condition_variable changed_;
    std::vector<std::vector<std::uint8_t>> frames_;
    bool held_ = false;
};

class Block : public testing::Test
{
  protected:
    ~Block() override { screen.let_go(); }

    void open(BlockForm form = BlockForm::Extended,
              std::optional<std::chrono::milliseconds> patience = std::nullopt)
    {
        auto opened = EmulatedBlock::open(
            model, {.form = form, .size = size, .threads = 1, .patience = patience},
            [this](const engine::Image& image) { screen.take(image); });
        ASSERT_TRUE(opened);
        block = std::move(*opened);
    }
    std::uint32_t read(Register reg) { return block->read(at(reg)); }
    void write(Register reg, std::uint32_t word) { block->write(at(reg), word); }
    void write_words(const protocol::Words& words)
    {
        for (std::uint16_t i = 0; i < model.description->word_count; ++i)
            block->write({static_cast<std::uint16_t>(4 * i)}, words[i]);
    }
    /// Waits for the interrupt, takes it and clears the frame-done flag.
    std::uint32_t take_interrupt()
    {
        EXPECT_TRUE(test::readable(block->interrupt_fd()));
        const auto count = block->take_interrupt();
        EXPECT_TRUE(count);
        write(Register::Status, status::frame_done);
        return count.value_or(0);
    }

    Screen screen; // outlives the block
    std::unique_ptr<EmulatedBlock> block;
};

protocol::Words default_words()
{
    return protocol::pack(*model.description, protocol::initial_state(*model.description));
}

protocol::Words cube_words()
{
    protocol::State state = protocol::initial_state(*model.description);
    state.codes[protocol::marcher::OBJ] = 1;
    return protocol::pack(*model.description, state);
}

engine::Image picture_of(const protocol::Words& words)
{
    engine::Image image(size);
    draw(model, words, image, 1);
    return image;
}

constexpr std::uint32_t in_shadow = control::enable | control::interrupt_enable | control::shadow;

TEST_F(Block, TellsWhatItIs)
{
    open();
    EXPECT_EQ(read(Register::Id), 0x524D'4152U);
    EXPECT_EQ(read(Register::Version), 0x0001'0000U);
    EXPECT_EQ(read(Register::Capability), 0x0004'0000U);
    EXPECT_EQ(read(Register::Geometry), 0x0008'0006U);
    EXPECT_EQ(read(Register::ClockHz), 100'000'000U);
    EXPECT_EQ(read(Register::Control), 0U);
    EXPECT_EQ(read(Register::Status), 0U);
    EXPECT_EQ(read(Register::Frames), 0U);
    EXPECT_EQ(block->read({0x4C}), 0U);  // after the last register
    EXPECT_EQ(block->read({0xFFC}), 0U); // the page's end
    EXPECT_FALSE(block->lost());
}

TEST_F(Block, ReadOnlyRegistersStay)
{
    open();
    for (const Register reg :
         {Register::Id, Register::Version, Register::Capability, Register::Geometry,
          Register::Frames, Register::Cycles, Register::ClockHz}) {
        const std::uint32_t before = read(reg);
        write(reg, 0xDEAD'BEEF);
        EXPECT_EQ(read(reg), before) << static_cast<int>(reg);
    }
    write(Register::Scratch, 0xDEAD'BEEF);
    EXPECT_EQ(read(Register::Scratch), 0xDEAD'BEEFU);
    write(Register::Control, 0xFFFF'FFF7); // all but soft reset
    EXPECT_EQ(read(Register::Control), 0x7U);
}

TEST_F(Block, WordsReadBackAtOnce)
{
    open();
    write_words(cube_words());
    for (std::uint16_t i = 0; i < 8; ++i)
        EXPECT_EQ(block->read({static_cast<std::uint16_t>(4 * i)}), cube_words()[i]) << i;
}

TEST_F(Block, DrawsWhatWasCommitted)
{
    open();
    write(Register::Control, in_shadow);
    write_words(default_words());
    EXPECT_EQ(read(Register::Status), 0U); // in shadow mode no frame starts
    write(Register::Commit, 1);
    EXPECT_EQ(screen.frame(1), picture_of(default_words()).rgb);
    EXPECT_EQ(take_interrupt(), 1U);
    EXPECT_EQ(read(Register::Frames), 1U);
    EXPECT_EQ(read(Register::Status),
              0U); // it is neither busy nor pending, and frame done was cleared
}

TEST_F(Block, CyclesAreThoseOfTheModel)
{
    open();
    write(Register::Control, in_shadow);
    write_words(cube_words());
    write(Register::Commit, 1);
    static_cast<void>(take_interrupt());
    engine::Image image(size);
    const auto costs = draw(model, cube_words(), image, 1);
    EXPECT_EQ(read(Register::Cycles), engine::frame_cycles(model, cube_words(), size, 0, costs));
}

TEST_F(Block, ACommitWaitsForTheFrameThatIsBeingDrawn)
{
    open();
    screen.hold();
    write(Register::Control, in_shadow);
    write_words(default_words());
    write(Register::Commit, 1);
    static_cast<void>(screen.frame(1)); // the worker is inside the first frame
    EXPECT_EQ(read(Register::Status), status::busy);

    write_words(cube_words());
    EXPECT_EQ(read(Register::Status), status::busy); // without a commit nothing is pending
    write(Register::Commit, 1);
    EXPECT_EQ(read(Register::Status), status::busy | status::commit_pending);
    screen.let_go();

    EXPECT_EQ(screen.frame(2), picture_of(cube_words()).rgb);
    EXPECT_EQ(screen.frame(1), picture_of(default_words()).rgb); // old and new words are not mixed
}

TEST_F(Block, WhileDisabledNothingIsDrawn)
{
    open();
    write(Register::Control, control::shadow | control::interrupt_enable);
    write_words(default_words());
    write(Register::Commit, 1);
    EXPECT_EQ(read(Register::Status), status::commit_pending);
    EXPECT_EQ(read(Register::Frames), 0U);
    write(Register::Control, in_shadow);
    EXPECT_EQ(take_interrupt(), 1U);
    EXPECT_EQ(read(Register::Frames), 1U);
}

TEST_F(Block, WithoutShadowAWordTakesEffectByItself)
{
    open();
    write(Register::Control, control::enable | control::interrupt_enable);
    block->write({0x00}, default_words()[0]);
    static_cast<void>(take_interrupt());
    EXPECT_GE(read(Register::Frames), 1U);
}

TEST_F(Block, AnInterruptComesOnceUntilItIsArmed)
{
    open();
    write(Register::Control, in_shadow);
    write(Register::Commit, 1);
    EXPECT_EQ(take_interrupt(), 1U);
    EXPECT_FALSE(test::readable(block->interrupt_fd(), 0));
    EXPECT_FALSE(block->take_interrupt()); // there is no interrupt

    write(Register::Commit, 1); // the interrupt is masked
    static_cast<void>(screen.frame(2));
    while (read(Register::Frames) < 2) // the sink is called just before the count
        std::this_thread::yield();
    EXPECT_FALSE(test::readable(block->interrupt_fd(), 0));

    block->arm_interrupt(); // the line is level-triggered, and frame done is still set
    EXPECT_EQ(take_interrupt(), 2U);
}

TEST_F(Block, ArmingWithoutAFrameDoneWaitsForTheNext)
{
    open();
    write(Register::Control, in_shadow);
    write(Register::Commit, 1);
    static_cast<void>(take_interrupt()); // this clears frame done
    block->arm_interrupt();
    EXPECT_FALSE(test::readable(block->interrupt_fd(), 0));
    write(Register::Commit, 1);
    EXPECT_EQ(take_interrupt(), 2U);
}

TEST_F(Block, WithoutInterruptEnableTheLineStaysDown)
{
    open();
    write(Register::Control, control::enable | control::shadow);
    write(Register::Commit, 1);
    while ((read(Register::Status) & status::frame_done) == 0)
        std::this_thread::yield();
    EXPECT_FALSE(test::readable(block->interrupt_fd(), 0));
    write(Register::Control,
          in_shadow); // the line is level-triggered, so enabling it raises the interrupt
    EXPECT_EQ(take_interrupt(), 1U);
}

TEST_F(Block, ASoftResetClearsWordsAndCounts)
{
    open();
    write(Register::Control, in_shadow);
    write_words(cube_words());
    write(Register::Commit, 1);
    static_cast<void>(take_interrupt());
    write(Register::Control, control::soft_reset);
    EXPECT_EQ(read(Register::Control), 0U); // soft reset clears itself
    EXPECT_EQ(read(Register::Status), 0U);
    EXPECT_EQ(read(Register::Frames), 0U);
    EXPECT_EQ(read(Register::Cycles), 0U);
    for (std::uint16_t i = 0; i < 8; ++i)
        EXPECT_EQ(block->read({static_cast<std::uint16_t>(4 * i)}), 0U) << i;
}

TEST_F(Block, TheBareFormHasThe8WordsOnly)
{
    open(BlockForm::Bare);
    EXPECT_EQ(block->interrupt_fd(), -1);
    for (std::uint16_t offset = 0x20; offset < 0x1000;
         offset = static_cast<std::uint16_t>(offset + 4)) {
        block->write({offset}, 0xFFFF'FFFF);
        EXPECT_EQ(block->read({offset}), 0U) << offset;
    }
    block->write({0x00}, default_words()[0]); // each word takes effect by itself
    static_cast<void>(screen.frame(1));
    EXPECT_EQ(block->read({0x00}), default_words()[0]);
}

TEST_F(Block, TheBareFormEndsUpWithTheLastWords)
{
    open(BlockForm::Bare);
    screen.hold();
    block->write({0x00}, default_words()[0]);
    static_cast<void>(
        screen.frame(1)); // the worker is in a frame; the next frame has all later words
    write_words(cube_words());
    screen.let_go();
    EXPECT_EQ(screen.frame(2), picture_of(cube_words()).rgb);
}

constexpr std::chrono::milliseconds none{0}; // every frame is slow

TEST_F(Block, ASlowFrameIsShownCoarseFirst)
{
    open(BlockForm::Extended, none);
    write(Register::Control, in_shadow);
    write_words(cube_words());
    write(Register::Commit, 1);
    const engine::Image expected = picture_of(cube_words());
    engine::Image coarse(size);
    std::size_t shown = 0;
    for (const unsigned grid : {8U, 4U, 2U}) {
        engine::spread(expected, grid, coarse);
        EXPECT_EQ(screen.frame(++shown), coarse.rgb) << grid;
    }
    EXPECT_EQ(screen.frame(++shown), expected.rgb);
    EXPECT_EQ(take_interrupt(), 1U);
    EXPECT_EQ(read(Register::Frames), 1U); // one frame, however often it was shown
    const auto cycles = read(Register::Cycles);
    engine::Image image(size);
    const auto costs = draw(model, cube_words(), image, 1);
    EXPECT_EQ(cycles, engine::frame_cycles(model, cube_words(), size, 0, costs));
}

TEST_F(Block, NewerWordsEndASlowFrame)
{
    open(BlockForm::Extended, none);
    screen.hold();
    write(Register::Control, in_shadow);
    write_words(default_words());
    write(Register::Commit, 1);
    engine::Image coarse(size);
    engine::spread(picture_of(default_words()), 8, coarse);
    EXPECT_EQ(screen.frame(1), coarse.rgb); // the worker is held there
    write_words(cube_words());
    write(Register::Commit, 1);
    screen.let_go();
    engine::spread(picture_of(cube_words()), 8, coarse);
    EXPECT_EQ(screen.frame(2), coarse.rgb);
    EXPECT_EQ(screen.frame(5), picture_of(cube_words()).rgb);
    EXPECT_EQ(take_interrupt(), 1U);
    EXPECT_EQ(read(Register::Frames), 1U); // the other frame was not completed
    EXPECT_EQ(read(Register::Status), 0U);
}

TEST_F(Block, EndsWhileItDraws)
{
    open();
    write(Register::Control, in_shadow);
    write(Register::Commit, 1);
    block.reset(); // it must wait only for the frame
}

} // namespace
} // namespace raymarch::emulation
