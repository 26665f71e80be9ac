// SPDX-License-Identifier: MIT
#include "engine/fractal/frame.hpp"

#include "engine/draw.hpp"
#include "engine/fractal/fractal.hpp"
#include "engine/models.hpp"
#include "protocol/accelerators/fractal.hpp"
#include "protocol/registers.hpp"
#include "tests/engine/fractal/vectors.hpp"

#include <gtest/gtest.h>

namespace raymarch::engine::fractal
{
namespace
{

namespace table = protocol::fractal;

protocol::State initial()
{
    return protocol::initial_state(table::description);
}

protocol::Words words_of(const protocol::State& state)
{
    return protocol::pack(table::description, state);
}

TEST(FractalFrame, TheDefaultsAreTheStateAfterReset)
{
    const Frame frame = latch(words_of(initial()));
    EXPECT_EQ(frame.position, (Point{word(0), one, -three_halves}));
    EXPECT_EQ(frame.forward, (Point{word(0), word(0), one}));
    EXPECT_EQ(frame.scene, Scene::Menger);
    EXPECT_FALSE(frame.dither || frame.texture || frame.checker || frame.colour);
    EXPECT_EQ(frame.hue, 0);
}

// By hand: word 6 has the scene in bits 1:0, the switches in 4 to 7, the hue in 15:8.
TEST(FractalFrame, WhereTheBitsStand)
{
    constexpr std::array<std::uint32_t, 7> words = {0x00200000, 0x001FFFFF, 0x003FFFFF, 0x003E8000,
                                                    1,          0xFFC00002, 0x0000AB03};
    const Frame frame = latch(words);
    EXPECT_EQ(frame.position, (Point{word(-2097152), word(2097151), word(-1)}));
    EXPECT_EQ(frame.forward, (Point{-three_halves, word(1), word(2)})); // the rest does not count
    EXPECT_EQ(frame.scene, Scene::Maze);
    EXPECT_EQ(frame.hue, 0xAB);

    const auto with = [](std::uint32_t word6) {
        return latch(std::array<std::uint32_t, 7>{0, 0, 0, 0, 0, 0, word6});
    };
    EXPECT_TRUE(with(1 << 4).dither);
    EXPECT_TRUE(with(1 << 5).texture);
    EXPECT_TRUE(with(1 << 6).checker);
    EXPECT_TRUE(with(1 << 7).colour);
    EXPECT_FALSE(with(~(1U << 4)).dither);
    EXPECT_FALSE(with(~(1U << 5)).texture);
    EXPECT_FALSE(with(~(1U << 6)).checker);
    EXPECT_FALSE(with(~(1U << 7)).colour);
}

TEST(FractalFrame, TheWalkIsInNoWord)
{
    protocol::State state = initial();
    state.codes[table::COLLISION] = 1;
    const protocol::Words walking = words_of(state);
    const protocol::Words still = words_of(initial());
    EXPECT_TRUE(std::equal(walking.begin(), walking.end(), still.begin(), still.end()));
}

TEST(FractalFrame, TheModelDrawsAndCountsFromWords)
{
    protocol::State state = initial();
    state.codes[table::SCENE] = 2;
    const Model& model = model_of(table::description);
    const protocol::Words words = words_of(state);
    Image image(test::size);
    const std::vector<PixelCost> costs = draw(model, words, image, 1);
    EXPECT_EQ(engine::frame_cycles(model, words, test::size, 0, costs), 400'465U); // on 12 units
    EXPECT_EQ(frames_of_a_still(model, words), 1U);
    state.codes[table::CHECKER] = 1;
    EXPECT_EQ(frames_of_a_still(model, words_of(state)), 4U);
    Image other(test::size);
    Painter painter(1);
    draw_still(painter, {model, words_of(state)}, other);
    EXPECT_EQ(other.rgb, image.rgb);
}

} // namespace
} // namespace raymarch::engine::fractal
