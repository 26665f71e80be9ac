// SPDX-License-Identifier: MIT
/// @file
/// The marcher's kernels against the model: random cameras, sizes, parts of pictures. Set
/// RAYMARCH_IDENTITY_ROUNDS to multiply how many (default 1), RAYMARCH_IDENTITY_SEED for others.
#include "engine/marcher/frame.hpp"
#include "identity.hpp"
#include "protocol/accelerators/marcher.hpp"
#include "protocol/assignments.hpp"
#include "protocol/registers.hpp"

#include <array>
#include <cmath>
#include <cstdlib>
#include <numbers>
#include <random>
#include <string>

namespace raymarch::engine::identity
{
namespace
{

namespace table = protocol::marcher;

const Model& model = model_of(table::description);

unsigned number_from_environment(const char* name, unsigned otherwise)
{
    const char* const text = std::getenv(name);
    return text == nullptr ? otherwise : static_cast<unsigned>(std::strtoul(text, nullptr, 10));
}

using Random = std::mt19937;
using protocol::State;
using protocol::Words;

int rounds(int once)
{
    return once * static_cast<int>(number_from_environment("RAYMARCH_IDENTITY_ROUNDS", 1));
}

Random random_of(unsigned test)
{
    return Random(number_from_environment("RAYMARCH_IDENTITY_SEED", 1) * 1000 + test);
}

int between(Random& random, int least, int most)
{
    return std::uniform_int_distribution(least, most)(random);
}

double real(Random& random, double least, double most)
{
    return std::uniform_real_distribution(least, most)(random);
}

/// Which scene a test is about.
class Marcher : public testing::TestWithParam<int>
{
  protected:
    const int scene = GetParam();

    [[nodiscard]] State initial() const
    {
        State state = protocol::initial_state(table::description);
        state.codes[table::OBJ] = scene;
        return state;
    }
};

using Axes = std::array<protocol::ParameterIndex, 3>;
constexpr Axes forward = {table::FX, table::FY, table::FZ};
constexpr Axes right = {table::RX, table::RY, table::RZ};
constexpr Axes up = {table::UX, table::UY, table::UZ};

void set(State& state, const Axes& axes, const std::array<double, 3>& v)
{
    for (std::size_t i = 0; i < axes.size(); ++i)
        state.codes[axes[i]] =
            std::clamp<std::int64_t>(std::llround(std::ldexp(v[i], 17)), -131072, 131071);
}

/// An orthonormal basis: the source's camera with a roll.
void turn(State& state, double yaw, double pitch, double roll)
{
    const double cy = std::cos(yaw);
    const double sy = std::sin(yaw);
    const double cp = std::cos(pitch);
    const double sp = std::sin(pitch);
    const std::array<double, 3> f = {cp * sy, sp, cp * cy};
    const std::array<double, 3> r = {cy, 0, -sy};
    const std::array<double, 3> u = {-sp * sy, cp, -sp * cy};
    set(state, forward, f);
    std::array<double, 3> rolled_r{};
    std::array<double, 3> rolled_u{};
    for (std::size_t i = 0; i < 3; ++i) {
        rolled_r[i] = std::cos(roll) * r[i] + std::sin(roll) * u[i];
        rolled_u[i] = std::cos(roll) * u[i] - std::sin(roll) * r[i];
    }
    set(state, right, rolled_r);
    set(state, up, rolled_u);
}

void randomise_light_and_colour(State& state, Random& random)
{
    for (const auto i : {table::LX, table::LY, table::LZ})
        state.codes[i] =
            std::array{-512, 511, 0, between(random, -512, 511),
                       between(random, -40, 40)}[static_cast<std::size_t>(between(random, 0, 4))];
    for (const auto i : {table::R, table::G, table::B})
        state.codes[i] = std::array{
            0, 1023, between(random, 0, 1023)}[static_cast<std::size_t>(between(random, 0, 2))];
}

std::int64_t zoom(double units)
{
    return std::llround(std::ldexp(units, 24));
}

State random_camera(State state, Random& random, double least_zoom, double most_zoom)
{
    using std::numbers::pi;
    turn(state, real(random, -pi, pi), real(random, -pi / 2, pi / 2),
         between(random, 0, 1) * real(random, -pi, pi));
    state.codes[table::ZM] = zoom(real(random, least_zoom, most_zoom));
    randomise_light_and_colour(state, random);
    return state;
}

PictureSize small_size(Random& random)
{
    return {static_cast<std::uint16_t>(between(random, 1, 67)),
            static_cast<std::uint16_t>(between(random, 1, 37))};
}

Region random_region(Random& random, PictureSize size)
{
    const auto part = [&](int from, int to) {
        return static_cast<std::uint16_t>(between(random, from, to));
    };
    const std::uint16_t x = part(0, size.width - 1);
    const std::uint16_t y = part(0, size.height - 1);
    return {.size = size,
            .x = x,
            .y = y,
            .width = part(1, size.width - x),
            .height = part(1, size.height - y),
            .step = part(1, 9)};
}

Words words_of(const State& state)
{
    return protocol::pack(table::description, state);
}

TEST_P(Marcher, RandomCameras)
{
    Random random = random_of(0);
    for (int i = 0; i < rounds(400); ++i)
        expect_identity(model, words_of(random_camera(initial(), random, 0, 10)),
                        whole(small_size(random)));
}

TEST_P(Marcher, CamerasAtTheSurface)
{
    // Close to where the eye is in matter, at SURFACE_DIST, or just outside of an outline.
    Random random = random_of(1);
    for (int i = 0; i < rounds(200); ++i)
        expect_identity(model, words_of(random_camera(initial(), random, 0.2, 1.3)),
                        whole(small_size(random)));
}

TEST_P(Marcher, WordsOfAnyBits)
{
    // Bases of any length and angle, zooms up to the register's end.
    Random random = random_of(2);
    for (int i = 0; i < rounds(200); ++i) {
        Words words = words_of(initial());
        for (std::uint32_t& word : words)
            word = static_cast<std::uint32_t>(random());
        words[0] = (words[0] & 0x3FFF'FFFF) | static_cast<std::uint32_t>(scene) << 30;
        if (i % 2 == 0)
            words[1] >>= between(random, 0, 31);
        expect_identity(model, words, whole(small_size(random)));
    }
}

TEST_P(Marcher, DegenerateBases)
{
    Random random = random_of(3);
    for (int i = 0; i < rounds(200); ++i) {
        State state = random_camera(initial(), random, 0, 10);
        const auto any = [&]() -> const Axes& {
            return *std::array{&forward, &right,
                               &up}[static_cast<std::size_t>(between(random, 0, 2))];
        };
        const Axes& to = any();
        const Axes& from = any();
        for (std::size_t axis = 0; axis < 3; ++axis)
            switch (i % 5) {
            case 0: // missing
                state.codes[to[axis]] = 0;
                break;
            case 1: // collinear, or opposite
                state.codes[to[axis]] = std::min<std::int64_t>(-state.codes[from[axis]], 131071);
                break;
            case 2: // tiny
                state.codes[to[axis]] = between(random, -2, 2);
                break;
            case 3: // all at the ends of their range
                for (const Axes* const axes : {&forward, &right, &up})
                    state.codes[(*axes)[axis]] = between(random, 0, 1) == 0 ? -131072 : 131071;
                break;
            default: // thin: almost collinear
                state.codes[to[axis]] = std::clamp<std::int64_t>(
                    state.codes[from[axis]] + between(random, -900, 900), -131072, 131071);
            }
        expect_identity(model, words_of(state), whole(small_size(random)));
    }
}

TEST_P(Marcher, PartsAndSteps)
{
    Random random = random_of(4);
    for (int i = 0; i < rounds(200); ++i)
        expect_identity(model, words_of(random_camera(initial(), random, 0, 10)),
                        random_region(random, small_size(random)));
}

TEST_P(Marcher, RaysAlongTheAxes)
{
    // Directions with exact components, 1 and 0, along faces and through corners.
    Random random = random_of(5);
    for (int i = 0; i < rounds(60); ++i) {
        State state = initial();
        using std::numbers::pi;
        turn(state, pi / 4 * between(random, 0, 7), pi / 4 * between(random, -2, 2),
             pi / 4 * between(random, 0, 7));
        state.codes[table::ZM] =
            between(random, 0, 1) == 0
                ? zoom(between(random, 0, 40) / 4.0)
                : zoom(between(random, 0, 40) / 4.0) + between(random, -200'000, 200'000);
        state.codes[table::ZM] = std::max<std::int64_t>(state.codes[table::ZM], 0);
        randomise_light_and_colour(state, random);
        expect_identity(model, words_of(state), whole(small_size(random)));
    }
}

TEST_P(Marcher, PresetsInManySizes)
{
    for (const protocol::Preset& preset : table::presets) {
        State state = protocol::initial_state(table::description);
        protocol::ParameterSet given;
        ASSERT_FALSE(protocol::read_assignments(table::description, {.bytes = preset.settings},
                                                state, given));
        if (state.codes[table::OBJ] != scene)
            continue;
        for (const PictureSize size : {PictureSize{1, 1}, PictureSize{1, 50}, PictureSize{50, 1},
                                       PictureSize{97, 65}, PictureSize{160, 120}})
            expect_identity(model, words_of(state), whole(size));
    }
}

TEST_P(Marcher, LargePictures)
{
    Random random = random_of(6);
    for (int i = 0; i < rounds(1); ++i) {
        expect_identity(model, words_of(random_camera(initial(), random, 1.6, 4)),
                        {.size = {1920, 1080}, .y = 300, .width = 1920, .height = 33});
        expect_identity(model, words_of(random_camera(initial(), random, 1.6, 4)),
                        whole({641, 359}));
    }
}

INSTANTIATE_TEST_SUITE_P(Identity, Marcher, testing::Range(0, 4), [](const auto& of) {
    return std::string(table::scenes[static_cast<std::size_t>(of.param)]);
});

} // namespace
} // namespace raymarch::engine::identity
