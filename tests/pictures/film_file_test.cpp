// SPDX-License-Identifier: MIT
/// @file
/// What holds of every film, and the sequences; GIF and MP4 have files of their own.
#include "pictures/film_file.hpp"

#include "pictures/picture_file.hpp"
#include "tests/fakes/file_size_limit.hpp"
#include "tests/fakes/special_files.hpp"
#include "tests/fakes/temporary_folder.hpp"
#include "tests/pictures/test_pictures.hpp"

#include <gtest/gtest.h>

#include <sys/stat.h>

#include <array>
#include <filesystem>

namespace raymarch::pictures
{
namespace
{

using test::names_in;
using test::noise;
using Names = std::vector<std::string>;

constexpr engine::PictureSize size{9, 7};

std::string text_of(const std::vector<std::uint8_t>& bytes)
{
    return {bytes.begin(), bytes.end()};
}

TEST(FilmFormat, ByTheEnding)
{
    EXPECT_EQ(film_format_of("a.gif"), FilmFormat::Gif);
    EXPECT_EQ(film_format_of("a.GIF"), FilmFormat::Gif);
    EXPECT_EQ(film_format_of("a.mp4"), FilmFormat::Mp4);
    EXPECT_EQ(film_format_of("a_%04d.png"), FilmFormat::Sequence);
    EXPECT_EQ(film_format_of("a_%04d.tga"), FilmFormat::Sequence);
    for (const char* path : {"a", "a.avi", "gif", "-", ""}) {
        const auto format = film_format_of(path);
        ASSERT_FALSE(format) << path;
        EXPECT_EQ(format.error().kind, ErrorKind::Usage);
        EXPECT_NE(format.error().message.find(".gif or .mp4"), std::string::npos);
    }
}

TEST(Film, ASequenceIsAPictureForEachFrame)
{
    const test::TemporaryFolder folder;
    auto film = open_film(folder / "f_%03d.ppm", size, 25);
    ASSERT_TRUE(film) << film.error().message;
    for (std::uint32_t i = 0; i < 3; ++i)
        ASSERT_TRUE((*film)->add(noise(size, 50, i)));
    EXPECT_EQ((*film)->frames(), 3U);
    EXPECT_EQ(names_in(folder / "").size(), 1U); // the hidden folder
    ASSERT_TRUE((*film)->finish());
    film->reset();
    EXPECT_EQ(names_in(folder / ""), (Names{"f_000.ppm", "f_001.ppm", "f_002.ppm"}));
    for (std::uint32_t i = 0; i < 3; ++i)
        EXPECT_EQ(test::read_text(folder / ("f_00" + std::to_string(i) + ".ppm")),
                  text_of(encode(noise(size, 50, i), PictureFormat::Ppm).value()));
}

TEST(Film, ASequenceOfPng)
{
    const auto expected = encode(noise(size, 50), PictureFormat::Png);
    ASSERT_TRUE(expected) << expected.error().message;
    const test::TemporaryFolder folder;
    auto film = open_film(folder / "f.png", size, 25);
    ASSERT_TRUE(film) << film.error().message;
    ASSERT_TRUE((*film)->add(noise(size, 50)));
    ASSERT_TRUE((*film)->finish());
    film->reset();
    EXPECT_EQ(names_in(folder / ""), Names{"f_0000.png"});
    EXPECT_EQ(test::read_text(folder / "f_0000.png"), text_of(*expected));
}

TEST(Film, WhatCannotBeOpened)
{
    const test::TemporaryFolder folder;
    test::write_text(folder / "there.gif/file", "");
    struct Row
    {
        std::string path;
        engine::PictureSize size;
        unsigned frames_per_second;
        ErrorKind kind;
        const char* says;
    };
    for (const Row& row : {
             Row{folder / "a.avi", size, 25, ErrorKind::Usage, ".gif or .mp4"},
             Row{folder / "a.gif", size, 51, ErrorKind::Usage,
                 "51 frames a second; a GIF has 1 to 50"},
             Row{folder / "a.gif", size, 0, ErrorKind::Usage, "1 to 50"},
             Row{folder / "a.mp4", size, 241, ErrorKind::Usage, "1 to 240"},
             Row{folder / "a.ppm", size, 0, ErrorKind::Usage, "1 to 240"},
             Row{folder / "a.ppm", {0, 5}, 25, ErrorKind::Usage, "0x5"},
             Row{folder / "a_%x.ppm", size, 25, ErrorKind::Usage, "pattern"},
             Row{folder / "there.gif", size, 25, ErrorKind::Usage, "not a file"},
             Row{folder / "missing/a.ppm", size, 25, ErrorKind::InputOutput,
                 "missing/a.ppm: No such"},
         }) {
        const auto film = open_film(row.path, row.size, row.frames_per_second);
        ASSERT_FALSE(film) << row.path;
        EXPECT_EQ(film.error().kind, row.kind) << row.path;
        EXPECT_NE(film.error().message.find(row.says), std::string::npos) << film.error().message;
    }
    EXPECT_EQ(names_in(folder / ""), Names{"there.gif"});
}

TEST(Film, AFrameOfAnotherSizeSpoilsIt)
{
    const test::TemporaryFolder folder;
    auto film = open_film(folder / "f.ppm", size, 25);
    ASSERT_TRUE(film) << film.error().message;
    ASSERT_TRUE((*film)->add(noise(size, 5)));
    const auto added = (*film)->add(noise({9, 8}, 5));
    ASSERT_FALSE(added);
    EXPECT_EQ(added.error().kind, ErrorKind::BadData);
    EXPECT_NE(added.error().message.find("frame 1 is 9x8, the film is 9x7"), std::string::npos)
        << added.error().message;
    EXPECT_FALSE((*film)->add(noise(size, 5)));
    EXPECT_FALSE((*film)->finish());
    film->reset();
    EXPECT_EQ(names_in(folder / ""), Names{});
}

TEST(Film, WithoutFramesThereIsNone)
{
    const test::TemporaryFolder folder;
    auto film = open_film(folder / "f.ppm", size, 25);
    ASSERT_TRUE(film) << film.error().message;
    const auto finished = (*film)->finish();
    ASSERT_FALSE(finished);
    EXPECT_EQ(finished.error().kind, ErrorKind::BadData);
    film->reset();
    EXPECT_EQ(names_in(folder / ""), Names{});
}

TEST(Film, AbandonedLeavesWhatWasThere)
{
    const test::TemporaryFolder folder;
    test::write_text(folder / "f_0000.ppm", "older");
    {
        auto film = open_film(folder / "f.ppm", size, 25);
        ASSERT_TRUE(film) << film.error().message;
        ASSERT_TRUE((*film)->add(noise(size, 5)));
    }
    EXPECT_EQ(names_in(folder / ""), Names{"f_0000.ppm"});
    EXPECT_EQ(test::read_text(folder / "f_0000.ppm"), "older");
}

TEST(Film, TwoAtOnceUnderOneName)
{
    const test::TemporaryFolder folder;
    auto first = open_film(folder / "f.ppm", size, 25);
    auto second = open_film(folder / "f.ppm", size, 25);
    ASSERT_TRUE(first && second);
    ASSERT_TRUE((*first)->add(noise(size, 5, 1)) && (*second)->add(noise(size, 5, 2)));
    ASSERT_TRUE((*second)->finish() && (*first)->finish()); // the last one stays
    first->reset();
    second->reset();
    EXPECT_EQ(names_in(folder / ""), Names{"f_0000.ppm"});
    EXPECT_EQ(test::read_text(folder / "f_0000.ppm"),
              text_of(encode(noise(size, 5, 1), PictureFormat::Ppm).value()));
}

/// A film in each format that is built, of two frames, to `name` in the folder.
Result<void> make_film(const std::string& path)
{
    auto film = open_film(path, {16, 16}, 25);
    if (!film)
        return fail(film.error());
    for (std::uint32_t i = 0; i < 2; ++i)
        if (auto added = (*film)->add(noise({16, 16}, 5, i)); !added)
            return added;
    return (*film)->finish();
}

struct FilmName
{
    const char* name;       ///< as open_film() takes it
    const char* first_file; ///< that it makes
};
constexpr std::array film_names = {FilmName{"f.gif", "f.gif"}, FilmName{"f.mp4", "f.mp4"},
                                   FilmName{"f_%d.ppm", "f_0.ppm"}};

TEST(Film, LinksAndPermissionsStay)
{
    for (const FilmName& film : film_names) {
        const test::TemporaryFolder folder;
        const std::string real = folder / "other/real";
        test::write_text(real, "old");
        ASSERT_EQ(::chmod(real.c_str(), 0600), 0);
        std::filesystem::create_symlink("other/real", folder / film.first_file);
        const auto made = make_film(folder / film.name);
        if (!made && made.error().kind == ErrorKind::Unavailable)
            continue;
        ASSERT_TRUE(made) << made.error().message;
        EXPECT_TRUE(std::filesystem::is_symlink(folder / film.first_file));
        EXPECT_NE(test::read_text(real), "old");
        EXPECT_EQ(test::status_of(real).st_mode & 07777U, 0600U) << film.name;
        EXPECT_EQ(names_in(folder / "other"), Names{"real"});
        for (const std::string& name : names_in(folder / ""))
            EXPECT_NE(name.front(), '.') << name;
    }
}

TEST(Film, OnlyAFileIsReplaced)
{
    for (const FilmName& film : film_names) {
        const test::TemporaryFolder folder;
        ASSERT_EQ(::mkfifo((folder / film.first_file).c_str(), 0600), 0);
        const auto made = make_film(folder / film.name);
        ASSERT_FALSE(made);
        EXPECT_EQ(made.error().message, folder / film.first_file + " is a FIFO, not a file");
        EXPECT_TRUE(std::filesystem::is_fifo(folder / film.first_file));
        EXPECT_EQ(names_in(folder / ""), Names{film.first_file});
    }
}

TEST(Film, NamesMayBeLong)
{
    for (const std::string ending : {".gif", ".mp4"}) {
        const test::TemporaryFolder folder;
        const std::string name = std::string(255 - ending.size(), 'f') + ending;
        const auto made = make_film(folder / name);
        if (!made && made.error().kind == ErrorKind::Unavailable)
            continue;
        ASSERT_TRUE(made) << made.error().message;
        EXPECT_EQ(names_in(folder / ""), Names{name});
    }
}

TEST(Film, OnAFullDiskThereIsNone)
{
    for (const char* name : {"f.gif", "f.mp4", "f.ppm"}) {
        const test::TemporaryFolder folder;
        const test::FileSizeLimit limit(2'000);
        auto film = open_film(folder / name, {64, 64}, 25);
        if (!film && film.error().kind == ErrorKind::Unavailable)
            continue;
        ASSERT_TRUE(film) << film.error().message;
        Result<void> result;
        for (std::uint32_t i = 0; i < 10 && result; ++i)
            result = (*film)->add(noise({64, 64}, 200, i));
        if (result)
            result = (*film)->finish();
        ASSERT_FALSE(result) << name;
        EXPECT_EQ(result.error().kind, ErrorKind::InputOutput);
        EXPECT_NE(result.error().message.find(folder / std::string(name).substr(0, 1)),
                  std::string::npos)
            << result.error().message;
        film->reset();
        EXPECT_EQ(names_in(folder / ""), Names{});
    }
}

} // namespace
} // namespace raymarch::pictures
