// SPDX-License-Identifier: MIT
/// Tests every accelerator in the register block: its words go in, its finished picture comes out.
#include "emulation/emulated_block.hpp"

#include "engine/draw.hpp"
#include "engine/models.hpp"
#include "protocol/assignments.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <condition_variable>
#include <mutex>
#include <ostream>
#include <string>

namespace raymarch::engine
{

/// The name of a model's accelerator stands for it in the output of GoogleTest.
static void PrintTo(const Model& model, std::ostream* stream)
{
    *stream << model.description->name;
}

} // namespace raymarch::engine

namespace raymarch::emulation
{
namespace
{

using protocol::Register;
namespace control = protocol::control;

constexpr engine::PictureSize small_size = {24, 18};

/// Keeps the newest frame and the number of frames.
class NewestPicture
{
  public:
    void take(const engine::Image& image)
    {
        const std::scoped_lock lock(mutex_);
        newest_ = image;
        ++frames_;
        changed_.notify_all();
    }
    [[nodiscard]] engine::Image wait_for(unsigned frames)
    {
        std::unique_lock lock(mutex_);
        EXPECT_TRUE(
            changed_.wait_for(lock, std::chrono::seconds(60), [&] { return frames_ >= frames; }));
        return newest_;
    }

  private:
    std::mutex mutex_;
    std::condition_variable changed_;
    engine::Image newest_;
    unsigned frames_ = 0;
};

class AllModels : public testing::TestWithParam<engine::Model>
{
  protected:
    /// Compares the final picture of the block with that of draw_still().
    void expect_still(const protocol::State& state)
    {
        const engine::Model& model = GetParam();
        const protocol::Accelerator& accelerator = *model.description;
        const protocol::Words words = protocol::pack(accelerator, state);
        engine::Image expected(small_size);
        engine::Painter painter(1);
        draw_still(painter, {model, words}, expected);

        NewestPicture screen;
        const auto block = EmulatedBlock::open(
            model, {.form = BlockForm::Extended, .size = small_size, .threads = 2},
            [&](const engine::Image& image) { screen.take(image); });
        ASSERT_TRUE(block);
        const auto write = [&](std::size_t offset, std::uint32_t word) {
            (*block)->write({static_cast<std::uint16_t>(offset)}, word);
        };
        write(static_cast<std::size_t>(Register::Control), control::enable | control::shadow);
        for (std::size_t i = 0; i < words.size(); ++i)
            write(accelerator.first_word_offset + 4 * i, words[i]);
        write(static_cast<std::size_t>(Register::Commit), 1);
        EXPECT_EQ(screen.wait_for(frames_of_a_still(model, words)).rgb, expected.rgb);
    }
};

TEST_P(AllModels, TheDefaultsAreDrawnToTheEnd)
{
    expect_still(protocol::initial_state(*GetParam().description));
}

TEST_P(AllModels, TheFirstPresetIsDrawnToTheEnd)
{
    const protocol::Accelerator& accelerator = *GetParam().description;
    protocol::State state = protocol::initial_state(accelerator);
    protocol::ParameterSet given;
    ASSERT_FALSE(protocol::read_assignments(accelerator, {.bytes = accelerator.presets[0].settings},
                                            state, given));
    expect_still(state);
}

INSTANTIATE_TEST_SUITE_P(Models, AllModels, testing::ValuesIn(engine::models),
                         [](const auto& row) { return std::string(row.param.description->name); });

TEST(Checkerboard, IsCompleteAfterFourFrames)
{
    const engine::Model& model = engine::model_of(protocol::fractal::description);
    protocol::State state = protocol::initial_state(protocol::fractal::description);
    protocol::ParameterSet given;
    engine::Image whole(small_size);
    engine::Painter painter(1);
    draw_still(painter, {model, pack(*model.description, state)}, whole);
    ASSERT_FALSE(
        protocol::read_assignments(*model.description, {.bytes = "CHECKER=on"}, state, given));
    const protocol::Words words = pack(*model.description, state);
    EXPECT_EQ(frames_of_a_still(model, words), 4U);
    engine::Image halves(small_size);
    draw_still(painter, {model, words}, halves);
    EXPECT_EQ(halves.rgb, whole.rgb);
    engine::Image first(small_size);
    draw(model, words, first, 1, 0);
    EXPECT_NE(first.rgb, whole.rgb);
}

} // namespace
} // namespace raymarch::emulation
