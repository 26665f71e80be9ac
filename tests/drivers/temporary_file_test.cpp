// SPDX-License-Identifier: MIT
#include "base/temporary_file.hpp"

#include "drivers/atomic_file.hpp"
#include "tests/fakes/temporary_folder.hpp"

#include <gtest/gtest.h>

#include <sys/stat.h>

#include <filesystem>
#include <string>
#include <vector>

namespace raymarch::drivers
{
namespace
{

namespace fs = std::filesystem;
using test::names_in;
using Names = std::vector<std::string>;

TEST(TemporaryFile, WhatComesInItsWayMeanwhileStays)
{
    const test::TemporaryFolder folder;
    auto file = TemporaryFile::open(folder / "film");
    ASSERT_TRUE(file && file->write(as_bytes("frames")));
    ASSERT_EQ(::mkfifo((folder / "film").c_str(), 0600), 0);
    const auto finished = file->commit();
    ASSERT_FALSE(finished);
    EXPECT_EQ(finished.error().message, folder / "film" + " is a FIFO, not a file");
    EXPECT_TRUE(fs::is_fifo(folder / "film"));
    *file = *TemporaryFile::open(
        folder / "other"); // its temporary file is removed with the moved-from object
    file = TemporaryFile::open(folder / "missing/file");
    EXPECT_EQ(names_in(folder / ""), Names{"film"});
}

TEST(TemporaryFile, KeepsTheEndingOfItsName)
{
    const test::TemporaryFolder folder;
    for (const char* const name : {"film.mp4", "film.GIF", "a.b.png", "none"}) {
        const auto file = TemporaryFile::open(folder / name);
        ASSERT_TRUE(file);
        EXPECT_EQ(fs::path(file->path()).extension(), fs::path(name).extension());
        EXPECT_EQ(fs::path(file->path()).parent_path(), fs::path(folder / name).parent_path());
        EXPECT_EQ(fs::path(file->path()).filename().string().front(), '.');
    }
}

} // namespace
} // namespace raymarch::drivers
