// SPDX-License-Identifier: MIT
#include "pictures/film_file.hpp"
#include "pictures/load_module.hpp"
#include "tests/fakes/temporary_folder.hpp"
#include "tests/pictures/test_pictures.hpp"
#include "tests/pictures/video_reader.hpp"

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>

namespace raymarch::pictures
{
namespace
{

using test::names_in;
using Names = std::vector<std::string>;
using Colour = std::array<std::uint8_t, 3>;

struct Video
{
    double frames_per_second = 0;
    std::vector<engine::Image> frames{};
};

Video read_video(const std::string& path)
{
    const auto read = module_function<test::ReadVideoFunction>(test::video_reader_file,
                                                               test::video_reader_symbol);
    Video video;
    const test::FrameSink keep = [](void* context, const std::uint8_t* rgb, int width, int height) {
        engine::Image image(
            {static_cast<std::uint16_t>(width), static_cast<std::uint16_t>(height)});
        std::copy_n(rgb, image.rgb.size(), image.rgb.begin());
        static_cast<Video*>(context)->frames.push_back(std::move(image));
    };
    if (read != nullptr)
        video.frames_per_second = read(path.c_str(), keep, &video);
    return video;
}

/// Plain colours survive the codec, give or take.
const std::vector<Colour> colours = {{200, 30, 30}, {30, 180, 40}, {30, 40, 200}, {128, 128, 128}};

TEST(Mp4, CanBeReadBack)
{
    if (!test::has_video_module)
        GTEST_SKIP() << "the video module is not built: no videoio here";
    const test::TemporaryFolder folder;
    const std::string path = folder / "film 1.mp4";
    for (const engine::PictureSize size : {engine::PictureSize{160, 120}, {33, 17}, {1, 1}}) {
        auto film = open_film(path, size, 30);
        ASSERT_TRUE(film) << film.error().message;
        for (const Colour& colour : colours)
            ASSERT_TRUE((*film)->add(
                test::picture(size, [&](std::size_t, std::size_t) { return colour; })));
        ASSERT_TRUE((*film)->finish());
        film->reset();
        EXPECT_EQ(names_in(folder / ""), Names{"film 1.mp4"});
        EXPECT_GT(test::read_text(path).size(), 100U);

        const Video video = read_video(path);
        EXPECT_EQ(video.frames_per_second, 30.0);
        ASSERT_EQ(video.frames.size(), colours.size());
        for (std::size_t i = 0; i < colours.size(); ++i) {
            EXPECT_EQ(video.frames[i].size.width, size.width + size.width % 2);
            EXPECT_EQ(video.frames[i].size.height, size.height + size.height % 2);
            for (std::size_t c = 0; c < 3; ++c) // the last pixel is a repeated one at odd sizes
                EXPECT_LE(
                    std::abs(video.frames[i].rgb.rbegin()[2 - static_cast<int>(c)] - colours[i][c]),
                    24)
                    << "frame " << i << " channel " << c;
        }
    }
}

TEST(Mp4, AbandonedLeavesNothing)
{
    if (!test::has_video_module)
        GTEST_SKIP() << "the video module is not built: no videoio here";
    const test::TemporaryFolder folder;
    {
        auto film = open_film(folder / "f.mp4", {32, 32}, 30);
        ASSERT_TRUE(film) << film.error().message;
        ASSERT_TRUE((*film)->add(test::noise({32, 32}, 9)));
    }
    EXPECT_EQ(names_in(folder / ""), Names{});
}

TEST(Mp4, AColonInTheNameMakesNoAddress)
{
    if (!test::has_video_module)
        GTEST_SKIP() << "the video module is not built: no videoio here";
    const test::TemporaryFolder folder;
    const std::filesystem::path before = std::filesystem::current_path();
    std::filesystem::current_path(folder / "");
    auto film = open_film("film:1.mp4", {32, 32}, 30);
    EXPECT_TRUE(film && (*film)->add(test::noise({32, 32}, 9)) && (*film)->finish());
    std::filesystem::current_path(before);
    EXPECT_EQ(names_in(folder / ""), Names{"film:1.mp4"});
}

TEST(Mp4, WithoutTheModuleTheErrorNamesWhatIsThere)
{
    if (test::has_video_module)
        GTEST_SKIP() << "the module is there";
    const test::TemporaryFolder folder;
    const auto film = open_film(folder / "f.mp4", {32, 32}, 30);
    ASSERT_FALSE(film);
    EXPECT_EQ(film.error().kind, ErrorKind::Unavailable);
    EXPECT_NE(film.error().message.find("videoio"), std::string::npos);
    EXPECT_NE(film.error().message.find(".gif"), std::string::npos);
    EXPECT_NE(film.error().message.find(".png"), std::string::npos);
    EXPECT_EQ(names_in(folder / ""), Names{});
}

} // namespace
} // namespace raymarch::pictures
