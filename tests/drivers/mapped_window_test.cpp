// SPDX-License-Identifier: MIT
#include "drivers/mapped_window.hpp"

#include "drivers/bus_fault.hpp"
#include "drivers/lock_file.hpp"
#include "tests/fakes/file_size_limit.hpp"
#include "tests/fakes/other_process.hpp"
#include "tests/fakes/temporary_folder.hpp"
#include "tests/fakes/word_in.hpp"

#include <gtest/gtest.h>

#include <fcntl.h>
#include <signal.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <string>
#include <vector>

namespace raymarch::drivers
{
namespace
{

constexpr std::size_t page = 4096;

TEST(RegisterFile, WordsStandAtTheirOffsets)
{
    const test::TemporaryFolder folder;
    const std::string path = folder / "registers";
    const auto window = MappedWindow::open_file(path, page);
    ASSERT_TRUE(window) << window.error().message;
    (*window)->write({0x00}, 0x0102'0304);
    (*window)->write({0x1C}, 0xFFFF'0000);
    (*window)->write({0xFFC}, 0xCAFE'F00D);
    EXPECT_EQ((*window)->read({0x00}), 0x0102'0304U);
    EXPECT_EQ((*window)->read({0x04}), 0U);
    EXPECT_EQ(test::word_in(path, 0x00), 0x0102'0304U);
    EXPECT_EQ(test::word_in(path, 0x1C), 0xFFFF'0000U);
    EXPECT_EQ(test::word_in(path, 0xFFC), 0xCAFE'F00DU);
    EXPECT_EQ((*window)->interrupt_fd(), -1);
    EXPECT_FALSE((*window)->lost());
}

TEST(RegisterFile, WhatOthersWriteIsRead)
{
    const test::TemporaryFolder folder;
    const std::string path = folder / "registers";
    const auto window = MappedWindow::open_file(path, page);
    ASSERT_TRUE(window);
    const UniqueFd other(::open(path.c_str(), O_RDWR | O_CLOEXEC));
    const std::uint32_t word = 7;
    ASSERT_EQ(::pwrite(other.get(), &word, sizeof word, 0x20), 4);
    EXPECT_EQ((*window)->read({0x20}), 7U);
}

TEST(RegisterFile, ASmallFileGrowsAndKeepsWhatItHas)
{
    const test::TemporaryFolder folder;
    const std::string path = folder / "registers";
    test::write_text(path, std::string(4, '\xFF'));
    const auto window = MappedWindow::open_file(path, page);
    ASSERT_TRUE(window);
    EXPECT_EQ(std::filesystem::file_size(path), page);
    EXPECT_EQ((*window)->read({0}), 0xFFFF'FFFFU);
    EXPECT_EQ((*window)->read({4}), 0U);
}

TEST(RegisterFile, ALargeFileStaysLarge)
{
    const test::TemporaryFolder folder;
    const std::string path = folder / "registers";
    test::write_text(path, std::string(3 * page, 'x'));
    ASSERT_TRUE(MappedWindow::open_file(path, page));
    EXPECT_EQ(std::filesystem::file_size(path), 3 * page);
}

TEST(RegisterFile, AFileThatIsCutWhileMappedIsLost)
{
    const test::TemporaryFolder folder;
    const std::string path = folder / "registers";
    const auto window = MappedWindow::open_file(path, page);
    ASSERT_TRUE(window);
    (*window)->write({8}, 5);
    std::filesystem::resize_file(path, 0);
    EXPECT_EQ((*window)->read({8}), 0U);
    EXPECT_TRUE((*window)->lost());
    (*window)->write({8}, 6); // the store has no effect and does not end the process
}

TEST(RegisterFile, AWriteFindsTheLossToo)
{
    const test::TemporaryFolder folder;
    const std::string path = folder / "registers";
    const auto window = MappedWindow::open_file(path, page);
    ASSERT_TRUE(window);
    std::filesystem::resize_file(path, 0);
    (*window)->write({8}, 6);
    EXPECT_TRUE((*window)->lost());
}

TEST(RegisterFile, OnlyTheWindowThatLostItsFileIsLost)
{
    const test::TemporaryFolder folder;
    const auto cut = MappedWindow::open_file(folder / "cut", page);
    const auto whole = MappedWindow::open_file(folder / "whole", page);
    ASSERT_TRUE(cut && whole);
    std::filesystem::resize_file(folder / "cut", 0);
    EXPECT_EQ((*cut)->read({0}), 0U);
    EXPECT_TRUE((*cut)->lost());
    EXPECT_FALSE((*whole)->lost());
}

TEST(RegisterFile, OpenedAgainItIsNew)
{
    const test::TemporaryFolder folder;
    const std::string path = folder / "registers";
    {
        const auto window = MappedWindow::open_file(path, page);
        ASSERT_TRUE(window);
        std::filesystem::resize_file(path, 0);
        EXPECT_EQ((*window)->read({0}), 0U);
        EXPECT_TRUE((*window)->lost());
    }
    const auto again = MappedWindow::open_file(path, page);
    ASSERT_TRUE(again);
    EXPECT_FALSE((*again)->lost());
}

/// A new size in the middle of a page causes no fault.
TEST(RegisterFile, AFileThatIsShortenedIsLost)
{
    for (const std::size_t size : {page - 1, page / 2, std::size_t{1}}) {
        const test::TemporaryFolder folder;
        const std::string path = folder / "registers";
        const auto window = MappedWindow::open_file(path, page);
        ASSERT_TRUE(window);
        std::filesystem::resize_file(path, 2 * page);
        EXPECT_FALSE((*window)->lost()) << "a longer one is as good";
        std::filesystem::resize_file(path, size);
        EXPECT_TRUE((*window)->lost()) << size;
    }
}

TEST(RegisterFile, AFileThatIsReplacedMovedOrRemovedIsLost)
{
    const std::vector<void (*)(const std::string&)> ways = {
        [](const std::string& path) { std::filesystem::remove(path); },
        [](const std::string& path) { std::filesystem::rename(path, path + ".away"); },
        [](const std::string& path) {
            test::write_text(path + ".new", std::string(page, 'x'));
            std::filesystem::rename(path + ".new", path);
        },
        [](const std::string& path) {
            std::filesystem::create_hard_link(path, path + ".kept");
            std::filesystem::remove(path);
        },
        [](const std::string& path) {
            std::filesystem::remove_all(std::filesystem::path(path).parent_path());
        },
    };
    for (std::size_t way = 0; way < ways.size(); ++way) {
        const test::TemporaryFolder folder;
        std::filesystem::create_directory(folder / "run");
        const std::string path = folder / "run/registers";
        const auto window = MappedWindow::open_file(path, page);
        ASSERT_TRUE(window);
        EXPECT_FALSE((*window)->lost());
        ways[way](path);
        EXPECT_TRUE((*window)->lost()) << "way " << way;
    }
}

TEST(RegisterFile, HasOneOwnerWhoIsNamed)
{
    const test::TemporaryFolder folder;
    const std::string path = folder / "registers";
    test::write_text(path, "short");
    test::OtherProcess other([&] { return MappedWindow::open_file(path, page); });
    ASSERT_TRUE(other.has_it());
    std::filesystem::resize_file(path, 5);
    const auto second = MappedWindow::open_file(path, page);
    ASSERT_FALSE(second);
    EXPECT_TRUE(held_by_another(second.error()));
    EXPECT_NE(second.error().message.find("process " + std::to_string(other.pid())),
              std::string::npos)
        << second.error().message;
    EXPECT_EQ(std::filesystem::file_size(path), 5U) << "the second has not touched it";
    other.kill();
    EXPECT_TRUE(MappedWindow::open_file(path, page));
}

/// A signal from another process is not a fault: the process and the watch go on.
TEST(RegisterFile, AStraySignalDoesNotEndTheWatch)
{
    const test::TemporaryFolder folder;
    const auto window = MappedWindow::open_file(folder / "registers", page);
    ASSERT_TRUE(window);
    for (int i = 0; i < 3; ++i) {
        ASSERT_EQ(::kill(::getpid(), SIGBUS), 0);
        ASSERT_EQ(::raise(SIGBUS), 0);
    }
    EXPECT_FALSE((*window)->lost());
    std::filesystem::resize_file(folder / "registers", 0);
    EXPECT_EQ((*window)->read({8}), 0U);
    EXPECT_TRUE((*window)->lost());
}

/// A fault outside all watched mappings ends the process, also after a signal from outside.
TEST(BusFaultDeathTest, AFaultElsewhereEndsTheProcess)
{
    const test::TemporaryFolder folder;
    const auto fault = [&] {
        const auto window = MappedWindow::open_file(folder / "registers", page);
        ::raise(SIGBUS);
        const UniqueFd fd(::open((folder / "empty").c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0600));
        void* const base = ::mmap(nullptr, page, PROT_READ, MAP_SHARED, fd.get(), 0);
        std::_Exit(*static_cast<const volatile char*>(base));
    };
    // If a sanitizer handled the signal before, it ends the process in its own way.
    EXPECT_EXIT(
        fault(), [](int status) { return WIFSIGNALED(status) || WEXITSTATUS(status) != 0; }, "");
}

TEST(RegisterFile, OtherThingsThanFilesAreRefused)
{
    const test::TemporaryFolder folder;
    ASSERT_EQ(::mkfifo((folder / "pipe").c_str(), 0600), 0);
    for (const std::string& path : {folder / "pipe", folder / "", folder / "missing/file"}) {
        const auto window = MappedWindow::open_file(path, page);
        ASSERT_FALSE(window) << path;
        EXPECT_EQ(window.error().kind, ErrorKind::Unavailable);
        EXPECT_NE(window.error().message.find(path), std::string::npos) << window.error().message;
    }
}

TEST(RegisterFile, ThereAreAsManyWindowsAsCanBeWatched)
{
    const test::TemporaryFolder folder;
    std::vector<std::unique_ptr<MappedWindow>> windows;
    for (std::size_t i = 0; i < max_watched_mappings; ++i) {
        auto window = MappedWindow::open_file(folder / std::to_string(i), page);
        ASSERT_TRUE(window) << i;
        windows.push_back(std::move(*window));
    }
    EXPECT_FALSE(MappedWindow::open_file(folder / "one more", page));
    windows.pop_back();
    EXPECT_TRUE(MappedWindow::open_file(folder / "one more", page));
}

} // namespace
} // namespace raymarch::drivers
