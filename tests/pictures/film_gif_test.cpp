// SPDX-License-Identifier: MIT
#include "pictures/film_writers.hpp"
#include "pictures/palette.hpp"
#include "tests/fakes/temporary_folder.hpp"
#include "tests/pictures/gif_reader.hpp"
#include "tests/pictures/test_pictures.hpp"

#include <gtest/gtest.h>

namespace raymarch::pictures
{
namespace
{

using test::names_in;
using test::noise;
using Names = std::vector<std::string>;

std::string write_gif(const std::string& path, const std::vector<engine::Image>& frames,
                      unsigned frames_per_second)
{
    auto film = open_film(path, frames.front().size, frames_per_second);
    if (!film) {
        ADD_FAILURE() << film.error().message;
        return {};
    }
    for (const engine::Image& frame : frames)
        EXPECT_TRUE((*film)->add(frame));
    EXPECT_TRUE((*film)->finish());
    return test::read_text(path);
}

constexpr const char* no_module = "the picture module is not built";

TEST(Gif, DelaysAddUpToTheTime)
{
    EXPECT_EQ(gif_delay(0, 25), 4);
    EXPECT_EQ(gif_delay(0, 1), 100);
    EXPECT_EQ(gif_delay(999, 50), 2);
    for (unsigned rate = 1; rate <= 50; ++rate) {
        unsigned sum = 0;
        for (unsigned i = 0; i < rate; ++i) {
            EXPECT_GE(gif_delay(i, rate), 2);
            sum += gif_delay(i, rate);
        }
        EXPECT_EQ(sum, 100U) << rate;
    }
}

TEST(Gif, EveryPixelOfUpTo256Colours)
{
    if (!test::has_picture_module)
        GTEST_SKIP() << no_module;
    const test::TemporaryFolder folder;
    // Sizes and numbers of colours at which palette, code width and LZW's table change.
    struct Row
    {
        engine::PictureSize size;
        std::size_t colours;
    };
    for (const auto& [size, colours] :
         {Row{{1, 1}, 1}, Row{{16, 3}, 2}, Row{{5, 40}, 3}, Row{{31, 17}, 16}, Row{{200, 100}, 17},
          Row{{64, 64}, 1}, Row{{160, 120}, 256}}) {
        const std::vector<engine::Image> frames = {noise(size, colours, 1), noise(size, colours, 2),
                                                   noise(size, 1)};
        const std::string bytes = write_gif(folder / "f.gif", frames, 30);
        const test::Gif gif = test::GifReader(bytes).read();
        ASSERT_EQ(gif.frames.size(), frames.size());
        for (std::size_t i = 0; i < frames.size(); ++i) {
            EXPECT_EQ(gif.frames[i].size, size);
            EXPECT_TRUE(gif.frames[i].rgb == frames[i].rgb) << colours << " colours, frame " << i;
        }
        EXPECT_EQ(gif.delays, (std::vector<unsigned>{3, 3, 4}));
        EXPECT_TRUE(gif.for_ever);
        EXPECT_EQ(names_in(folder / ""), Names{"f.gif"});
    }
}

TEST(Gif, MoreColoursAreThoseOfThePalette)
{
    if (!test::has_picture_module)
        GTEST_SKIP() << no_module;
    const test::TemporaryFolder folder;
    const engine::Image frame = noise({90, 80}, 3000);
    const std::string bytes = write_gif(folder / "f.gif", {frame}, 10);
    const test::Gif gif = test::GifReader(bytes).read();
    const IndexedImage expected = indexed(frame);
    ASSERT_EQ(gif.frames.size(), 1U);
    for (std::size_t i = 0; i < expected.indices.size(); ++i)
        ASSERT_EQ(test::pixel(gif.frames[0], i % 90, i / 90),
                  expected.palette[expected.indices[i]]);
}

TEST(Gif, TheSameFramesAreTheSameBytes)
{
    if (!test::has_picture_module)
        GTEST_SKIP() << no_module;
    const test::TemporaryFolder folder;
    const std::vector<engine::Image> frames = {noise({40, 30}, 1000), noise({40, 30}, 10)};
    EXPECT_EQ(write_gif(folder / "a.gif", frames, 12), write_gif(folder / "b.gif", frames, 12));
}

TEST(Gif, IsThereWhenItIsWhole)
{
    if (!test::has_picture_module)
        GTEST_SKIP() << no_module;
    const test::TemporaryFolder folder;
    test::write_text(folder / "f.gif", "older");
    {
        auto film = open_film(folder / "f.gif", {8, 8}, 10);
        ASSERT_TRUE(film) << film.error().message;
        ASSERT_TRUE((*film)->add(noise({8, 8}, 4)));
        EXPECT_EQ(test::read_text(folder / "f.gif"), "older");
    }
    EXPECT_EQ(names_in(folder / ""), Names{"f.gif"});
    EXPECT_EQ(test::read_text(folder / "f.gif"), "older");
    EXPECT_NE(write_gif(folder / "f.gif", {noise({8, 8}, 4)}, 10), "older");
}

TEST(Gif, WithoutTheModuleTheErrorNamesWhatIsThere)
{
    if (test::has_picture_module)
        GTEST_SKIP() << "the module is there";
    const test::TemporaryFolder folder;
    const auto film = open_film(folder / "f.gif", {32, 32}, 30);
    ASSERT_FALSE(film);
    EXPECT_EQ(film.error().kind, ErrorKind::Unavailable);
    EXPECT_NE(film.error().message.find(".ppm"), std::string::npos);
    EXPECT_EQ(names_in(folder / ""), Names{});
}

} // namespace
} // namespace raymarch::pictures
