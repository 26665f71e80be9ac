// SPDX-License-Identifier: MIT
#include "drivers/mapped_window.hpp"

#include "drivers/bus_fault.hpp"
#include "drivers/lock_file.hpp"
#include "drivers/uio_device.hpp"
#include "tests/fakes/fake_kernel.hpp"
#include "tests/fakes/file_size_limit.hpp"
#include "tests/fakes/other_process.hpp"
#include "tests/fakes/temporary_folder.hpp"

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

/// The word at an offset of a file, in the machine's byte order.
std::uint32_t word_in(const std::string& path, std::size_t offset)
{
    const std::string bytes = test::read_text(path);
    std::uint32_t word = 0;
    EXPECT_GE(bytes.size(), offset + sizeof word);
    std::memcpy(&word, bytes.data() + offset, sizeof word);
    return word;
}

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
    EXPECT_EQ(word_in(path, 0x00), 0x0102'0304U);
    EXPECT_EQ(word_in(path, 0x1C), 0xFFFF'0000U);
    EXPECT_EQ(word_in(path, 0xFFC), 0xCAFE'F00DU);
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
    (*window)->write({8}, 6); // goes nowhere, and does not end the process
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

/// A size in the middle of a page raises no fault at all.
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

/// A signal that somebody sends is no fault of memory: it ends nothing, and the watch goes on.
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

/// A fault at a place that nobody watches still ends the process, also after a stray signal.
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
    // A sanitizer that had the signal before ends the process in its own way.
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

/// A sysfs tree, and an ordinary file that plays the device.
class Uio : public testing::Test
{
  protected:
    void add(const std::string& device, const std::string& name, const std::string& size,
             const std::string& offset = "0x0\n")
    {
        test::add_uio(root, device, size, name + "\n");
        test::write_text(root + "/class/uio/" + device + "/maps/map0/offset", offset);
        test::write_text(folder / ("dev/" + device), std::string(2 * page, '\0'));
    }
    [[nodiscard]] std::string node(const std::string& device) const
    {
        return folder / ("dev/" + device);
    }
    [[nodiscard]] Result<std::unique_ptr<MappedWindow>> open(const std::string& device) const
    {
        const auto description = describe_uio(tree, node(device));
        if (!description)
            return fail(description.error());
        return MappedWindow::open_uio(*description, page);
    }
    void expect_unavailable(const std::string& device, const std::string& part) const
    {
        const auto window = open(device);
        ASSERT_FALSE(window);
        EXPECT_EQ(window.error().kind, ErrorKind::Unavailable);
        EXPECT_NE(window.error().message.find(part), std::string::npos) << window.error().message;
    }

    test::TemporaryFolder folder;
    std::string root = folder / "sys";
    KernelTree tree{root};
};

TEST_F(Uio, IsFoundByItsName)
{
    add("uio0", "other", "0x1000\n");
    add("uio3", "raymarch", "0x00001000\n", "0x40\n");
    add("uio12", "raymarch2", "0x2000\n");
    const auto device = find_uio(tree, "raymarch");
    ASSERT_TRUE(device) << device.error().message;
    EXPECT_EQ(device->node, node("uio3"));
    EXPECT_EQ(device->name, "raymarch");
    EXPECT_EQ(device->address, 0x43C0'0000U);
    EXPECT_EQ(device->size, 0x1000U);
    EXPECT_EQ(device->offset, 0x40U);
    EXPECT_EQ(find_uio(tree, "raymarch2")->node, node("uio12"));
}

TEST_F(Uio, NodesOfTheSystemAreInItsDev)
{
    EXPECT_EQ(KernelTree().beside("dev/uio0"), "/dev/uio0");
}

TEST_F(Uio, IsDescribedThroughALinkToo)
{
    add("uio3", "raymarch", "0x1000\n");
    std::filesystem::create_symlink("uio3", folder / "dev/raymarch");
    const auto device = describe_uio(tree, folder / "dev/raymarch");
    ASSERT_TRUE(device) << device.error().message;
    EXPECT_EQ(device->node, folder / "dev/raymarch");
    EXPECT_EQ(device->size, 0x1000U);
}

TEST_F(Uio, NoDeviceOrTwoOfANameAreErrors)
{
    EXPECT_FALSE(find_uio(tree, "raymarch")); // no tree at all
    add("uio0", "raymarch", "0x1000\n");
    add("uio1", "raymarch", "0x1000\n");
    const auto two = find_uio(tree, "raymarch");
    ASSERT_FALSE(two);
    EXPECT_EQ(two.error().kind, ErrorKind::Config); // waiting would not help
    EXPECT_EQ(two.error().message, "2 UIO devices are named raymarch");
    const auto none = find_uio(tree, "nothing");
    ASSERT_FALSE(none);
    EXPECT_EQ(none.error().kind, ErrorKind::Unavailable);
    EXPECT_NE(none.error().message.find("nothing"), std::string::npos);
}

TEST_F(Uio, OpensWhatSysfsDescribes)
{
    add("uio0", "raymarch", "0x1000\n");
    const auto window = open("uio0");
    ASSERT_TRUE(window) << window.error().message;
    (*window)->write({0x20}, 0x1234'5678);
    EXPECT_EQ(word_in(node("uio0"), 0x20), 0x1234'5678U);
    EXPECT_GE((*window)->interrupt_fd(), 0);
    EXPECT_EQ(word_in(node("uio0"), 0), 1U); // a 1 was written to the device: unmasked
}

TEST_F(Uio, RegistersBeginAtTheOffset)
{
    add("uio0", "raymarch", "0x1000\n", "0x40\n");
    const auto window = open("uio0");
    ASSERT_TRUE(window) << window.error().message;
    (*window)->write({0x20}, 0x1234'5678);
    EXPECT_EQ(word_in(node("uio0"), 0x60), 0x1234'5678U);
    (*window)->write({0xFFC}, 9);
    EXPECT_EQ(word_in(node("uio0"), 0x103C), 9U);
}

TEST_F(Uio, RefusalsNameTheDevice)
{
    expect_unavailable("uio9", "uio9");
    add("uio0", "raymarch", "0x800\n");
    expect_unavailable("uio0", "4096");
    add("uio1", "raymarch", "many\n");
    expect_unavailable("uio1", "map0/size");
    add("uio2", "raymarch", "");
    expect_unavailable("uio2", "uio2");
    add("uio3", "raymarch", "0x1000\n", "0x1000\n");
    expect_unavailable("uio3", "one page");
    add("uio4", "raymarch", "0x1000\n");
    std::filesystem::remove(node("uio4"));
    expect_unavailable("uio4", "open");
}

TEST_F(Uio, HasOneOwnerWhoIsNamed)
{
    add("uio0", "raymarch", "0x1000\n");
    std::filesystem::create_symlink("uio0", folder / "dev/raymarch"); // as udev's rule makes it
    const test::OtherProcess other([&] { return open("uio0"); });
    ASSERT_TRUE(other.has_it());
    for (const char* const device : {"uio0", "raymarch"}) {
        const auto second = open(device);
        ASSERT_FALSE(second);
        EXPECT_TRUE(held_by_another(second.error()));
        EXPECT_NE(second.error().message.find("process " + std::to_string(other.pid())),
                  std::string::npos)
            << second.error().message;
    }
}

TEST_F(Uio, ADeviceWhoseNodeIsGoneIsLost)
{
    add("uio0", "raymarch", "0x1000\n");
    const auto window = open("uio0");
    ASSERT_TRUE(window);
    EXPECT_FALSE((*window)->lost());
    std::filesystem::remove(node("uio0"));
    EXPECT_TRUE((*window)->lost());
}

/// The file's bytes play the interrupts: each read takes the next four, each write goes there too.
/// The registers stand behind them.
TEST_F(Uio, InterruptsAreCountedAndArmedAgain)
{
    add("uio0", "raymarch", "0x1000\n", "0x40\n");
    const auto counts = [](std::uint32_t count) {
        return std::string(reinterpret_cast<const char*>(&count), sizeof count);
    };
    const std::string zero(4, '\0');
    test::write_text(node("uio0"),
                     zero + counts(7) + zero + counts(10) + std::string(2 * page, '\0'));
    const auto window = open("uio0");
    ASSERT_TRUE(window) << window.error().message;
    EXPECT_EQ(word_in(node("uio0"), 0), 1U) << "armed when opened";
    EXPECT_EQ((*window)->take_interrupt().value(), 7U);
    EXPECT_EQ(word_in(node("uio0"), 8), 0U);
    (*window)->arm_interrupt();
    EXPECT_EQ(word_in(node("uio0"), 8), 1U);
    EXPECT_EQ((*window)->take_interrupt().value(), 10U) << "two came unseen";
}

/// A device without a line refuses to be armed; here because it is at its largest size.
TEST_F(Uio, ADeviceWithoutALineHasNoInterrupt)
{
    add("uio0", "raymarch", "0x1000\n");
    const auto device = describe_uio(tree, node("uio0"));
    ASSERT_TRUE(device);
    const test::FileSizeLimit none(0); // no write succeeds
    const auto window = MappedWindow::open_uio(*device, page);
    ASSERT_TRUE(window) << window.error().message;
    EXPECT_EQ((*window)->interrupt_fd(), -1);
    (*window)->arm_interrupt(); // and nothing happens
    (*window)->write({0}, 5);
    EXPECT_EQ((*window)->read({0}), 5U);
}

} // namespace
} // namespace raymarch::drivers
