// SPDX-License-Identifier: MIT
/// @file
/// The sphere tracer's kernels: the reference's bytes and costs, whatever the words.
#include "identity.hpp"
#include "protocol/accelerators/sphere.hpp"
#include "protocol/assignments.hpp"
#include "protocol/registers.hpp"
#include "tests/fakes/random.hpp"

#include <array>
#include <cstdint>
#include <random>
#include <string>

namespace raymarch::engine::identity
{
namespace
{

namespace table = protocol::sphere;
using Random = std::mt19937_64;
using test::pick;

const Model& model = model_of(table::description);

protocol::Words words_of(std::string_view settings)
{
    protocol::State state = protocol::initial_state(table::description);
    protocol::ParameterSet given;
    EXPECT_FALSE(protocol::read_assignments(table::description, {.bytes = settings}, state, given))
        << settings;
    return protocol::pack(table::description, state);
}

/// The designs and their faults: word 0, bits 3:0, all sixteen; and the tint.
constexpr std::uint32_t mode_bits = 0x1F;

Region any_region(Random& random)
{
    const PictureSize size{pick<std::uint16_t>(random, 1, 50), pick<std::uint16_t>(random, 1, 24)};
    Region region = whole(size);
    if (pick(random, 0, 1) == 0)
        return region;
    region.x = pick<std::uint16_t>(random, 0, size.width - 1);
    region.y = pick<std::uint16_t>(random, 0, size.height - 1);
    region.width = pick<std::uint16_t>(random, 1, size.width - region.x);
    region.height = pick<std::uint16_t>(random, 1, size.height - region.y);
    region.step = pick<std::uint16_t>(random, 1, 5);
    return region;
}

/// Every eighth pixel of the whole picture, and a row and a column of it.
void expect_identity_across(protocol::Words& words, PictureSize size)
{
    Region region = whole(size);
    region.step = 8;
    expect_identity(model, words, region);
    const auto middle = static_cast<std::uint16_t>(size.height / 2);
    expect_identity(model, words, {.size = size, .y = middle, .width = size.width, .height = 1});
    expect_identity(model, words, {.size = size, .x = 321, .width = 1, .height = size.height});
}

TEST(SphereIdentity, EveryPresetInEveryDesignWithEveryFault)
{
    for (const protocol::Preset& preset : table::presets) {
        protocol::Words words = words_of(preset.settings);
        expect_identity(model, words, whole(table::description.size));
        for (std::uint32_t mode = 0; mode <= mode_bits; ++mode) {
            words[0] = (words[0] & ~mode_bits) | mode;
            expect_identity_across(words, table::description.size);
        }
    }
}

TEST(SphereIdentity, AnyWords)
{
    Random random = test::seeded_random();
    for (int i = 0; i < 3000; ++i) {
        std::array<std::uint32_t, table::description.word_count> words{};
        for (std::uint32_t& word : words)
            word = static_cast<std::uint32_t>(random());
        expect_identity(model, words, any_region(random));
    }
}

/// Scenes about a small picture, of all magnitudes up to those that 53 bits do not hold: balls that
/// are seen, touch, contain the eye or the light, lights in the points that they light.
TEST(SphereIdentity, AnyScene)
{
    Random random = test::seeded_random();
    const auto near = [&](int middle, int spread) {
        return std::to_string(middle + pick(random, -spread, spread));
    };
    for (int i = 0; i < 4000; ++i) {
        const int unit = 1 << pick(random, 3, 13);
        const auto place = [&](const std::string& key) {
            return key + ".X=" + near(20, unit) + "," + key + ".Y=" + near(12, unit) + "," + key +
                   ".Z=" + near(unit, unit);
        };
        std::string settings =
            "EX=" + near(20, unit / 2) + ",EY=" + near(12, unit / 2) + ",EZ=" + near(0, unit / 2) +
            ",F=" + near(unit / 2, unit / 2) +
            ",D=" + std::to_string(pick(random, 0, 99) < 20 ? 0 : pick(random, 1, 300)) +
            ",K=" + std::to_string(pick(random, 0, 400)) +
            ",CUTOFF=" + std::to_string(pick(random, 0, 40)) +
            ",N=" + std::to_string(pick(random, 0, 3)) + ",M=" + std::to_string(pick(random, 0, 8));
        for (const std::string key : {"S1", "S2", "S3"})
            settings +=
                "," + place(key) + "," + key + ".R=" + std::to_string(pick(random, 0, unit));
        for (int light = 1; light <= 8; ++light) {
            const std::string key = "L" + std::to_string(light);
            settings += "," + place(key) + "," + key +
                        ".S=" + std::to_string(pick(random, 0, 1 << pick(random, 0, 30)));
        }
        protocol::Words words = words_of(settings);
        words[0] = (words[0] & ~mode_bits) | pick<std::uint32_t>(random, 0, mode_bits);
        expect_identity(model, words, any_region(random));
    }
}

TEST(SphereIdentity, EverySizeOfARow)
{
    const protocol::Words words = words_of(table::presets[2].settings);
    for (std::uint16_t length = 1; length < 40; ++length)
        expect_identity(model, words,
                        {.size = {640, 480}, .x = 300, .y = 200, .width = length, .height = 3});
    expect_identity(model, words, whole({1919, 3}));
}

} // namespace
} // namespace raymarch::engine::identity
