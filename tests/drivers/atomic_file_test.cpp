// SPDX-License-Identifier: MIT
#include "drivers/atomic_file.hpp"

#include "tests/fakes/temporary_folder.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <string>

namespace raymarch::drivers
{
namespace
{

class AtomicFile : public testing::TestWithParam<Durability>
{
  protected:
    [[nodiscard]] static Result<void> replace(const std::string& path, std::string_view text)
    {
        return replace_file(path, as_bytes(text), GetParam());
    }
    test::TemporaryFolder folder;
    std::string path = folder / "file";
};

INSTANTIATE_TEST_SUITE_P(Both, AtomicFile,
                         testing::Values(Durability::Durable, Durability::BestEffort));

TEST_P(AtomicFile, IsMadeAndReplaced)
{
    ASSERT_TRUE(replace(path, "first"));
    EXPECT_EQ(test::read_text(path), "first");
    ASSERT_TRUE(replace(path, std::string("\0\xFF", 2)));
    EXPECT_EQ(test::read_text(path), std::string("\0\xFF", 2));
    ASSERT_TRUE(replace(path, ""));
    EXPECT_EQ(test::read_text(path), "");
    EXPECT_FALSE(std::filesystem::exists(path + ".new"));
}

TEST_P(AtomicFile, AnOpenReaderKeepsTheOldContent)
{
    ASSERT_TRUE(replace(path, "old"));
    std::ifstream reader(path);
    ASSERT_TRUE(replace(path, "new and longer"));
    std::string seen;
    std::getline(reader, seen);
    EXPECT_EQ(seen, "old");
}

TEST_P(AtomicFile, WithoutItsFolderItIsAnErrorThatNamesIt)
{
    const auto result = replace(folder / "missing/file", "x");
    ASSERT_FALSE(result);
    EXPECT_EQ(result.error().kind, ErrorKind::InputOutput);
    EXPECT_EQ(result.error().number, ENOENT);
    EXPECT_NE(result.error().message.find(folder / "missing/file"), std::string::npos);
}

TEST_P(AtomicFile, WhatCannotBeReplacedStays)
{
    std::filesystem::create_directory(path); // a file cannot take a folder's place
    const auto result = replace(path, "x");
    ASSERT_FALSE(result);
    EXPECT_EQ(result.error().kind, ErrorKind::InputOutput);
    EXPECT_NE(result.error().message.find(path), std::string::npos);
    EXPECT_TRUE(std::filesystem::is_directory(path));
}

TEST_P(AtomicFile, AnOldUnfinishedOneIsNoObstacle)
{
    test::write_text(path + ".new", "left behind by a power cut");
    ASSERT_TRUE(replace(path, "new"));
    EXPECT_EQ(test::read_text(path), "new");
}

TEST(ReadFile, ReadsUpToItsLimit)
{
    const test::TemporaryFolder folder;
    const std::string content(10'000, 'x'); // more than one read
    test::write_text(folder / "file", content);
    EXPECT_EQ(read_file(folder / "file", 10'000).value(), content);
    const auto over = read_file(folder / "file", 9'999);
    ASSERT_FALSE(over);
    EXPECT_EQ(over.error().kind, ErrorKind::BadData);
    EXPECT_TRUE(over.error().message.starts_with(folder / "file")) << over.error().message;
    EXPECT_NE(over.error().message.find("9999"), std::string::npos);
}

TEST(ReadFile, AMissingFileIsNamed)
{
    const test::TemporaryFolder folder;
    const auto result = read_file(folder / "none", 10);
    ASSERT_FALSE(result);
    EXPECT_EQ(result.error().kind, ErrorKind::Unavailable);
    EXPECT_NE(result.error().message.find(folder / "none"), std::string::npos);
}

TEST(ReadFile, AFolderIsNoFile)
{
    const test::TemporaryFolder folder;
    const auto result = read_file(folder / "", 10);
    ASSERT_FALSE(result);
    EXPECT_EQ(result.error().kind, ErrorKind::InputOutput);
}

} // namespace
} // namespace raymarch::drivers
