// SPDX-License-Identifier: MIT
/// @file
/// The ray tracer's kernels against its scalar model: presets, and scenes of every kind, with words
/// that no frame can set.
#include "identity.hpp"
#include "protocol/assignments.hpp"
#include "protocol/registers.hpp"
#include "tests/engine/whitted/report.hpp"
#include "tests/fakes/random.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace raymarch::engine::identity
{
namespace
{

namespace table = protocol::whitted;
using raymarch::test::pick;
using Random = std::mt19937_64;

const Model& model = model_of(table::description);
constexpr bool optimised = whitted::test::optimised;

/// The defaults with settings, and changes to those.
protocol::Words words_of(std::string_view settings, std::string_view changes = "")
{
    protocol::State state = protocol::initial_state(table::description);
    for (const std::string_view some : {settings, changes}) {
        protocol::ParameterSet given;
        if (!some.empty()) {
            EXPECT_FALSE(
                protocol::read_assignments(table::description, {.bytes = some}, state, given))
                << some;
        }
    }
    return protocol::pack(table::description, state);
}

/// One time in `times`.
bool rarely(Random& random, int times)
{
    return pick(random, 1, times) == 1;
}

/// A word of about this size.
std::int64_t coordinate(Random& random, std::int64_t scale)
{
    return rarely(random, 12) ? pick<std::int64_t>(random, -8, 8) * 4096
                              : pick<std::int64_t>(random, -scale, scale - 1);
}

constexpr std::array<std::int64_t, 9> scales = {
    1 << 12, 1 << 15,         1 << 16, 1 << 17, 1 << 18,
    1 << 20, 512 * 4096 + 40, 1 << 22, 1 << 23}; // 2048 units are where words end

std::int64_t scale(Random& random)
{
    return scales[pick<std::size_t>(random, 0, scales.size() - 1)];
}

/// A plane's normal: of unit length, along an axis, or anything.
std::array<std::int64_t, 3> normal(Random& random)
{
    std::array<std::int64_t, 3> components{};
    if (rarely(random, 3)) {
        components[pick<std::size_t>(random, 0, 2)] = rarely(random, 2) ? 4096 : -4096;
        return components;
    }
    const bool any = rarely(random, 12);
    std::array<double, 3> v{};
    for (double& c : v)
        c = std::uniform_real_distribution<>(-1, 1)(random);
    const double length = std::hypot(v[0], v[1], v[2]);
    for (std::size_t i = 0; i < 3; ++i)
        components[i] = any ? coordinate(random, 1 << 23)
                            : std::lround(v[i] / length * (rarely(random, 9) ? 4310 : 4096));
    return components;
}

/// A scene whose lengths are of some size, now and then of another.
protocol::Words scene(Random& random)
{
    protocol::State state = protocol::initial_state(table::description);
    const std::int64_t usual = scale(random);
    const auto length = [&] {
        return coordinate(random, rarely(random, 25) ? scale(random) : usual);
    };
    const auto set = [&](std::size_t i, std::int64_t code) { state.codes[i] = code; };
    const auto any = [&](std::int64_t highest) { return pick<std::int64_t>(random, 0, highest); };
    set(table::PROFILE, any(1));
    set(table::REFLECTIONS, any(3));
    set(table::AA, any(3));
    set(table::PLANES, any(3) != 0);
    set(table::N, any(15));
    for (const table::Index i : {table::EX, table::EY, table::EZ, table::LX, table::LY, table::LZ})
        set(i, length());
    set(table::LR, any(5));
    set(table::S, rarely(random, 8) ? coordinate(random, 1 << 23) : 256 << any(10));
    if (!rarely(random, 4)) { // mostly with the spheres in front of it
        set(table::EZ, -usual - any(usual));
        set(table::S, 32768 >> any(3));
    }
    for (std::size_t row = 0; row < table::sphere::Keys::rows; ++row) {
        const auto column = [&](table::sphere::Column c) { return table::index_of(c, row); };
        using namespace table::sphere; // NOLINT(google-build-using-namespace): its columns
        const bool twin = row > 0 && rarely(random, 10); // coincides with the one before
        for (const Column c : {X, Y, Z})
            set(column(c), twin ? state.codes[table::index_of(c, row - 1)] : length());
        set(column(RADIUS),
            rarely(random, 20) ? any(2047) : any(std::max<std::int64_t>(2, usual >> 13)) & 2047);
        for (const Column c : {R, G, B})
            set(column(c), rarely(random, 3) ? 0 : any(31));
        set(column(REFLECT), any(4095) | any(4095));
    }
    for (std::size_t row = 0; row < table::plane::Keys::rows; ++row) {
        const auto column = [&](table::plane::Column c) { return table::index_of(c, row); };
        using namespace table::plane; // NOLINT(google-build-using-namespace): its columns
        const std::array components = normal(random);
        set(column(A), components[0]);
        set(column(B), components[1]);
        set(column(C), components[2]);
        set(column(D), length());
        for (const Column c : {RED, GREEN, BLUE})
            set(column(c), rarely(random, 2) ? 0 : any(31));
        set(column(CHECKER), any(15));
        set(column(BOUNDED), rarely(random, 3));
        set(column(REFLECT), any(4095) | any(4095));
        for (const Column c : {XL, YL, ZL})
            set(column(c), rarely(random, 4) ? any(4095) : (usual >> 12) + 1);
    }
    return protocol::pack(table::description, state);
}

Region region(Random& random, PictureSize size)
{
    Region part = whole(size);
    if (rarely(random, 2)) {
        part.x = pick<std::uint16_t>(random, 0, static_cast<std::uint16_t>(size.width - 1));
        part.y = pick<std::uint16_t>(random, 0, static_cast<std::uint16_t>(size.height - 1));
        const auto up_to = [&](int most) {
            return static_cast<std::uint16_t>(pick(random, 1, most));
        };
        part.width = up_to(size.width - part.x);
        part.height = up_to(size.height - part.y);
        part.step = pick<std::uint16_t>(random, 1, 4);
    }
    return part;
}

PictureSize small_size(Random& random)
{
    return {pick<std::uint16_t>(random, 1, 23), pick<std::uint16_t>(random, 1, 9)};
}

class WhittedPreset : public testing::TestWithParam<protocol::Preset>
{};

TEST_P(WhittedPreset, KernelsDrawTheReferencesPicture)
{
    const protocol::Words words = words_of(GetParam().settings);
    expect_identity(model, words, whole(optimised ? PictureSize{511, 301} : PictureSize{61, 35}));
}

TEST_P(WhittedPreset, EitherProfileWithAndWithoutReflections)
{
    for (const std::string_view changes :
         {"PROFILE=measured", "PROFILE=repaired", "REFLECTIONS=0", "PROFILE=measured,AA=4x",
          "AA=4x", "PROFILE=measured,AA=8x,EZ=3", "EX=-40,AA=8x"})
        expect_identity(model, words_of(GetParam().settings, changes),
                        whole(optimised ? PictureSize{131, 87} : PictureSize{29, 17}));
}

INSTANTIATE_TEST_SUITE_P(Identity, WhittedPreset, testing::ValuesIn(table::presets),
                         [](const auto& of) { return std::string(of.param.name); });

TEST(WhittedKernels, DrawRandomScenes)
{
    Random random = raymarch::test::seeded_random();
    for (int i = 0; i < (optimised ? 3000 : 100) && !testing::Test::HasFailure(); ++i) {
        const protocol::Words words = scene(random);
        expect_identity(model, words, region(random, small_size(random)));
    }
}

TEST(WhittedKernels, DrawRandomWords)
{
    Random random = raymarch::test::seeded_random();
    for (int i = 0; i < (optimised ? 600 : 40) && !testing::Test::HasFailure(); ++i) {
        protocol::Words words =
            protocol::pack(table::description, protocol::initial_state(table::description));
        for (std::size_t j = 0; j < table::description.word_count; ++j)
            words[j] = static_cast<std::uint32_t>(random());
        expect_identity(model, words, region(random, small_size(random)));
    }
}

TEST(WhittedKernels, DrawScenesWithSomeRandomWords)
{
    Random random = raymarch::test::seeded_random();
    for (int i = 0; i < (optimised ? 600 : 40) && !testing::Test::HasFailure(); ++i) {
        protocol::Words words = scene(random);
        for (int changes = pick(random, 1, 3); changes > 0; --changes)
            words[pick<std::size_t>(random, 0, table::description.word_count - 1)] ^=
                1U << pick(random, 0, 31);
        expect_identity(model, words, region(random, small_size(random)));
    }
}

/// In the original machine a ray along a plane can come so far that its height above another wraps.
TEST(WhittedKernels, PointsFarFromAPlaneAreTheReferences)
{
    const auto* const room =
        std::ranges::find(table::presets, "image2_room", &protocol::Preset::name);
    ASSERT_NE(room, table::presets.end());
    const protocol::Words words = words_of(room->settings, "PROFILE=measured,AA=8x,REFLECTIONS=3");
    expect_identity(model, words,
                    {.size = {512, 480}, .x = 320, .y = 130, .width = 12, .height = 8});
}

TEST(WhittedKernels, TilesMeetWithoutASeam)
{
    // Tiles are 128 pixels wide: one row of each number of them, and of one pixel more or less.
    const protocol::Words words = words_of("AA=8x,N=9");
    constexpr std::array<std::uint16_t, 7> widths = {127, 128, 129, 255, 256, 257, 300};
    constexpr std::array<std::uint16_t, 3> steps = {1, 2, 3};
    for (const std::uint16_t width : widths)
        for (const std::uint16_t step : steps)
            expect_identity(model, words,
                            {.size = {width, 3}, .width = width, .height = 3, .step = step});
}

TEST(WhittedKernels, AnEyeInsideASphereSeesBlack)
{
    const protocol::Words words = words_of("S7.Z=-32,AA=8x");
    for (const Kernel* const kernel : kernels_here(model)) {
        const Drawn drawn = draw_region(model, kernel, words, whole({33, 21}), Costs::Unwanted);
        EXPECT_TRUE(std::ranges::all_of(drawn.rgb, [](int byte) { return byte == 0; }));
    }
    expect_identity(model, words, whole({33, 21}));
}

} // namespace
} // namespace raymarch::engine::identity
