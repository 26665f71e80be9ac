// SPDX-License-Identifier: MIT
/// @file
/// The fractal's kernels: the reference's bytes and costs, whatever the words.
#include "identity.hpp"
#include "protocol/accelerators/fractal.hpp"
#include "protocol/assignments.hpp"
#include "protocol/registers.hpp"
#include "tests/fakes/random.hpp"

#include <array>
#include <cstdint>
#include <random>

namespace raymarch::engine::identity
{
namespace
{

namespace table = protocol::fractal;
using Random = std::mt19937_64;
using test::pick;

const Model& model = model_of(table::description);

constexpr std::size_t mode_word = 6;
constexpr std::uint32_t scene_mask = 3;
constexpr std::uint32_t checker_bit = 1 << 6;

protocol::Words words_of(std::string_view settings)
{
    protocol::State state = protocol::initial_state(table::description);
    protocol::ParameterSet given;
    EXPECT_FALSE(protocol::read_assignments(table::description, {.bytes = settings}, state, given));
    return protocol::pack(table::description, state);
}

/// A small picture, as a rule cut to a part that is drawn in steps, of any frame.
Region any_region(Random& random)
{
    const PictureSize size{pick<std::uint16_t>(random, 1, 90), pick<std::uint16_t>(random, 1, 40)};
    Region region = whole(size, pick<std::uint32_t>(random, 0, 7));
    if (pick(random, 0, 1) == 0)
        return region;
    region.x = pick<std::uint16_t>(random, 0, size.width - 1);
    region.y = pick<std::uint16_t>(random, 0, size.height - 1);
    region.width = pick<std::uint16_t>(random, 1, size.width - region.x);
    region.height = pick<std::uint16_t>(random, 1, size.height - region.y);
    region.step = pick<std::uint16_t>(random, 1, 5);
    return region;
}

TEST(FractalIdentity, EveryPresetInEveryMode)
{
    for (const protocol::Preset& preset : table::presets) {
        protocol::Words words = words_of(preset.settings);
        expect_identity(model, words, whole({131, 97}));
        for (std::uint32_t modes = 0; modes < 16; ++modes) { // dither, texture, checker, colour
            words[mode_word] = (words[mode_word] & ~0xF0U) | modes << 4;
            expect_identity(model, words, whole({61, 35}, modes));
        }
    }
}

TEST(FractalIdentity, TheHardwaresPicture)
{
    for (std::uint32_t scene = 0; scene <= scene_mask; ++scene) {
        protocol::Words words = words_of(table::presets[0].settings);
        words[mode_word] = (words[mode_word] & ~scene_mask) | scene;
        expect_identity(model, words, whole(table::description.size));
    }
}

TEST(FractalIdentity, AnyWords)
{
    Random random = test::seeded_random();
    for (int i = 0; i < 3000; ++i) {
        std::array<std::uint32_t, 7> words{};
        for (std::uint32_t& word : words)
            word = static_cast<std::uint32_t>(random());
        expect_identity(model, words, any_region(random));
    }
}

/// Random words are mostly rays of no length in particular, and cameras in matter: here forward
/// vectors of usual lengths, from positions that are often free, often at a power of two.
TEST(FractalIdentity, AnyCamera)
{
    Random random = test::seeded_random();
    for (int i = 0; i < 3000; ++i) {
        std::array<std::uint32_t, 7> words{};
        const int spread = pick(random, 0, 1) == 0 ? 0 : 1 << pick(random, 1, 12);
        const std::int32_t grid = 1 << pick(random, 12, 17);
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const std::int32_t at = pick(random, -8, 8) * grid + pick(random, -spread, spread);
            words[axis] = static_cast<std::uint32_t>(at);
            const std::int32_t reach = 1 << pick(random, 12, 18);
            words[3 + axis] = static_cast<std::uint32_t>(
                pick(random, 0, 3) == 0 ? 0 : pick(random, -reach, reach));
        }
        words[mode_word] = static_cast<std::uint32_t>(random());
        expect_identity(model, words, any_region(random));
    }
}

TEST(FractalIdentity, EverySizeOfARowAndAColumn)
{
    protocol::Words words = words_of(table::presets[1].settings);
    for (unsigned at = 1; at < 300; at += at < 70 ? 1 : 23) {
        const auto length = static_cast<std::uint16_t>(at);
        words[mode_word] ^= checker_bit | 1;
        expect_identity(model, words, whole({length, 3}, length));
        expect_identity(model, words, whole({3, length}, length));
    }
    expect_identity(model, words, whole({1599, 5}));
    expect_identity(model, words, {.size = {65535, 2}, .x = 65400, .width = 135, .height = 2});
}

} // namespace
} // namespace raymarch::engine::identity
