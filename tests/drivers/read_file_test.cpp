// SPDX-License-Identifier: MIT
/// @file
/// Tests read_file() and set_aside().
#include "drivers/atomic_file.hpp"
#include "tests/fakes/special_files.hpp"
#include "tests/fakes/temporary_folder.hpp"

#include <gtest/gtest.h>

#include <cerrno>
#include <filesystem>
#include <string>
#include <utility>

namespace raymarch::drivers
{
namespace
{

namespace fs = std::filesystem;
using test::names_in;

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

TEST(ReadFile, AMissingFileIsNamedAndToldFromOtherFailures)
{
    const test::TemporaryFolder folder;
    fs::create_symlink("nothing", folder / "dangling");
    fs::create_symlink("loop", folder / "loop");
    test::write_text(folder / "file", "");
    struct Row
    {
        const char* name;
        int number;
    };
    for (const Row& row : {Row{"none", ENOENT}, Row{"none/file", ENOENT}, Row{"dangling", ENOENT},
                           Row{"loop", ELOOP}, Row{"file/below", ENOTDIR}}) {
        const auto result = read_file(folder / row.name, 10);
        ASSERT_FALSE(result) << row.name;
        EXPECT_EQ(result.error().kind, ErrorKind::Unavailable);
        EXPECT_EQ(result.error().number, row.number) << row.name;
        EXPECT_NE(result.error().message.find(folder / row.name), std::string::npos);
    }
}

TEST(ReadFile, OnlyAFileIsReadAndNothingIsWaitedFor)
{
    const test::TemporaryFolder folder;
    const test::SpecialFiles special(folder / "");
    for (const auto& [name, what] : special.all()) {
        const auto result = read_file(folder / name, 10);
        ASSERT_FALSE(result) << name;
        EXPECT_EQ(result.error().kind, ErrorKind::InputOutput);
        EXPECT_EQ(result.error().number, 0);
        EXPECT_EQ(result.error().message, folder / name + " is " + what + ", not a file");
    }
    EXPECT_FALSE(read_file("/dev/zero", 10));
}

TEST(ReadFile, FilesOfTheKernelHaveNoSize)
{
    EXPECT_FALSE(read_file("/proc/self/status", 65'536).value().empty());
    const std::string page = "/sys/kernel/mm/transparent_hugepage/enabled";
    EXPECT_EQ(read_file(page, 4096).has_value(), fs::exists(page));
}

TEST(SetAside, TakesTheNextFreeName)
{
    const test::TemporaryFolder folder;
    const std::string path = folder / "state";
    test::write_text(folder / "state.bad-2", "of the user");
    fs::create_symlink("nothing", folder / "state.bad-3");
    for (const auto& [name, text] : {std::pair{"state.bad", "first"}, {"state.bad-4", "second"}}) {
        test::write_text(path, text);
        EXPECT_EQ(set_aside(path).value(), folder / name);
        EXPECT_EQ(test::read_text(folder / name), text);
        EXPECT_FALSE(fs::exists(path));
    }
    EXPECT_EQ(test::read_text(folder / "state.bad-2"), "of the user");
    EXPECT_TRUE(fs::is_symlink(folder / "state.bad-3"));
}

TEST(SetAside, ALinkStaysAndItsFileGoes)
{
    const test::TemporaryFolder folder;
    test::write_text(folder / "other/real", "damaged");
    fs::create_symlink("other/real", folder / "state");
    EXPECT_EQ(set_aside(folder / "state").value(), folder / "other/real.bad");
    EXPECT_TRUE(fs::is_symlink(folder / "state"));
    ASSERT_TRUE(replace_file(folder / "state", as_bytes("new"), Durability::Durable));
    EXPECT_EQ(test::read_text(folder / "other/real"), "new");
    EXPECT_EQ(test::read_text(folder / "other/real.bad"), "damaged");
}

TEST(SetAside, CutsANameThatIsTooLong)
{
    const test::TemporaryFolder folder;
    const std::string path = folder / std::string(255, 's');
    for (const char* const ending : {".bad", ".bad-2"}) {
        test::write_text(path, "x");
        const auto name = set_aside(path);
        ASSERT_TRUE(name) << name.error().message;
        EXPECT_TRUE(name->ends_with(std::string("s") + ending)) << *name;
        EXPECT_EQ(test::read_text(*name), "x");
    }
}

TEST(SetAside, WhatCannotBeSetAsideIsNamed)
{
    const test::TemporaryFolder folder;
    const auto missing = set_aside(folder / "none");
    ASSERT_FALSE(missing);
    EXPECT_EQ(missing.error().kind, ErrorKind::Unavailable);
    EXPECT_EQ(missing.error().number, ENOENT);
    const test::SpecialFiles special(folder / "");
    for (const auto& [name, what] : special.all()) {
        const auto result = set_aside(folder / name);
        ASSERT_FALSE(result) << name;
        EXPECT_EQ(result.error().message, folder / name + " is " + what + ", not a file");
    }
    EXPECT_EQ(names_in(folder / ""), special.names());
    const std::string path = folder / "file";
    for (int number = 1; number <= 100; ++number)
        test::write_text(path + (number == 1 ? ".bad" : ".bad-" + std::to_string(number)), "kept");
    test::write_text(path, "one too many");
    const auto full = set_aside(path);
    ASSERT_FALSE(full);
    EXPECT_EQ(full.error().number, EEXIST);
    EXPECT_EQ(test::read_text(path), "one too many");
    EXPECT_EQ(test::read_text(path + ".bad-100"), "kept");
}

} // namespace
} // namespace raymarch::drivers
