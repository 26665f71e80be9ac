// SPDX-License-Identifier: MIT
#include "drivers/atomic_file.hpp"

#include "base/unique_fd.hpp"
#include "tests/fakes/child.hpp"
#include "tests/fakes/file_size_limit.hpp"
#include "tests/fakes/special_files.hpp"
#include "tests/fakes/temporary_folder.hpp"

#include <gtest/gtest.h>

#include <fcntl.h>
#include <sys/stat.h>
#include <sys/xattr.h>
#include <unistd.h>

#include <array>
#include <cstring>
#include <filesystem>
#include <ostream>
#include <string>
#include <thread>
#include <vector>

namespace raymarch
{

static void PrintTo(Durability durability, std::ostream* stream)
{
    *stream << (durability == Durability::Durable ? "Durable" : "BestEffort");
}

} // namespace raymarch

namespace raymarch::drivers
{
namespace
{

namespace fs = std::filesystem;
using test::names_in;
using test::status_of;
using Names = std::vector<std::string>;

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
                         testing::Values(Durability::Durable, Durability::BestEffort),
                         [](const auto& row) { return testing::PrintToString(row.param); });

TEST_P(AtomicFile, IsMadeAndReplaced)
{
    ASSERT_TRUE(replace(path, "first"));
    EXPECT_EQ(test::read_text(path), "first");
    ASSERT_TRUE(replace(path, std::string("\0\xFF", 2)));
    EXPECT_EQ(test::read_text(path), std::string("\0\xFF", 2));
    ASSERT_TRUE(replace(path, ""));
    EXPECT_EQ(test::read_text(path), "");
    EXPECT_EQ(names_in(folder / ""), Names{"file"});
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

TEST_P(AtomicFile, OnlyAFileIsReplaced)
{
    const test::SpecialFiles special(folder / "");
    for (const auto& [name, what] : special.all()) {
        const std::string there = folder / name;
        const struct stat before = status_of(there);
        const auto result = replace(there, "x");
        ASSERT_FALSE(result) << name;
        EXPECT_EQ(result.error().kind, ErrorKind::InputOutput);
        EXPECT_EQ(result.error().message, there + " is " + what + ", not a file");
        const struct stat after = status_of(there);
        EXPECT_EQ(after.st_mode, before.st_mode) << name;
        EXPECT_EQ(after.st_ino, before.st_ino) << name;
        // A symbolic link to it gives the same result.
        fs::create_symlink(there, path);
        EXPECT_FALSE(replace(path, "x")) << name;
        EXPECT_EQ(status_of(there).st_ino, before.st_ino) << name;
        fs::remove(path);
    }
    EXPECT_EQ(names_in(folder / ""), special.names()) << "nothing unfinished is left";
}

TEST_P(AtomicFile, DevicesStay)
{
    for (const char* const name : {"null", "full"}) {
        const std::string device = test::spare_device(folder / "", name);
        if (device.empty())
            GTEST_SKIP() << "no device can be made here";
        const auto result = replace(device, "x");
        ASSERT_FALSE(result) << device;
        EXPECT_EQ(result.error().message, device + " is a character device, not a file");
        EXPECT_TRUE(fs::is_character_file(device));
    }
}

TEST_P(AtomicFile, ALinkStaysAndItsFileIsReplaced)
{
    fs::create_directories(folder / "other/place");
    test::write_text(folder / "other/place/real", "old");
    struct Row
    {
        const char* link;
        std::string target;
    };
    for (const Row& row :
         {Row{"absolute", folder / "other/place/real"}, Row{"relative", "other/place/real"},
          Row{"other/up", "../other/place/../place/real"}, Row{"chain", "other/up"},
          Row{"other/place/beside", "real"}}) {
        fs::create_symlink(row.target, folder / row.link);
        ASSERT_TRUE(replace(folder / row.link, row.link)) << row.link;
        EXPECT_EQ(fs::read_symlink(folder / row.link), row.target);
        EXPECT_EQ(test::read_text(folder / "other/place/real"), row.link);
    }
    fs::create_directory_symlink("other/place", folder / "folder");
    ASSERT_TRUE(replace(folder / "folder/real", "by a linked folder"));
    EXPECT_EQ(test::read_text(folder / "other/place/real"), "by a linked folder");
    EXPECT_EQ(names_in(folder / "other/place"), (Names{"beside", "real"}));
    EXPECT_EQ(names_in(folder / "other"), (Names{"place", "up"}));
    EXPECT_EQ(names_in(folder / ""), (Names{"absolute", "chain", "folder", "other", "relative"}));
}

TEST_P(AtomicFile, ALinkToNothingYetGetsItsFile)
{
    fs::create_directory(folder / "other");
    fs::create_symlink("other/later", path);
    fs::create_symlink("file", folder / "chain");
    ASSERT_TRUE(replace(folder / "chain", "new"));
    EXPECT_TRUE(fs::is_symlink(folder / "chain"));
    EXPECT_TRUE(fs::is_symlink(path));
    EXPECT_EQ(test::read_text(folder / "other/later"), "new");
    EXPECT_EQ(names_in(folder / "other"), Names{"later"});
}

TEST_P(AtomicFile, LinksThatLeadNowhereAreErrorsAndStay)
{
    fs::create_symlink("loop", folder / "loop");
    fs::create_symlink("b", folder / "a");
    fs::create_symlink("a", folder / "b");
    fs::create_symlink("missing/file", folder / "far");
    for (const char* const name : {"loop", "a", "far"}) {
        const auto result = replace(folder / name, "x");
        ASSERT_FALSE(result) << name;
        EXPECT_EQ(result.error().number, std::string_view(name) == "far" ? ENOENT : ELOOP);
        EXPECT_TRUE(fs::is_symlink(folder / name));
    }
    EXPECT_EQ(names_in(folder / ""), (Names{"a", "b", "far", "loop"}));
}

/// A link in /proc may lead to a file that was removed. No file is made under the name that the
/// kernel shows for it.
TEST_P(AtomicFile, AnOpenFileWithoutANameIsNotReplaced)
{
    test::write_text(path, "gone");
    const UniqueFd fd(::open(path.c_str(), O_RDWR | O_CLOEXEC));
    fs::remove(path);
    const auto result = replace("/proc/self/fd/" + std::to_string(fd.get()), "x");
    ASSERT_FALSE(result);
    EXPECT_NE(result.error().message.find("an open file without a name"), std::string::npos);
    EXPECT_EQ(names_in(folder / ""), Names{});
}

TEST_P(AtomicFile, PermissionsStay)
{
    for (const mode_t mode : {0600U, 0640U, 0664U, 0666U, 0755U, 0200U}) {
        test::write_text(path, "old");
        ASSERT_EQ(::chmod(path.c_str(), mode), 0);
        ASSERT_TRUE(replace(path, "new"));
        EXPECT_EQ(status_of(path).st_mode & 07777U, mode);
        ASSERT_EQ(::chmod(path.c_str(), 0600), 0);
        EXPECT_EQ(test::read_text(path), "new");
    }
    // New content does not keep the set-id bits.
    ASSERT_EQ(::chmod(path.c_str(), 06755), 0);
    ASSERT_TRUE(replace(path, "newer"));
    EXPECT_EQ(status_of(path).st_mode & 07777U, 0755U);
}

/// The test runs in a child process, because a umask belongs to all threads.
TEST_P(AtomicFile, ANewFileFollowsTheUmask)
{
    for (const mode_t mask : {0022U, 0002U, 0077U}) {
        const std::string name = folder / std::to_string(mask);
        EXPECT_EQ(test::status_in_child([&] {
                      ::umask(mask);
                      return replace(name, "x") ? 0 : 1;
                  }),
                  0);
        EXPECT_EQ(status_of(name).st_mode & 07777U, 0666U & ~mask);
    }
}

TEST_P(AtomicFile, OwnerAndGroupStay)
{
    if (::geteuid() != 0)
        GTEST_SKIP() << "only root gives files away";
    test::write_text(path, "old");
    ASSERT_EQ(::chown(path.c_str(), 65'000, 65'001), 0);
    ASSERT_EQ(::chmod(path.c_str(), 0640), 0);
    ASSERT_TRUE(replace(path, "new"));
    EXPECT_EQ(status_of(path).st_uid, 65'000U);
    EXPECT_EQ(status_of(path).st_gid, 65'001U);
    EXPECT_EQ(status_of(path).st_mode & 07777U, 0640U);
}

/// A user replaces a file of another user in a folder of their own. The new file belongs to them,
/// and if the group cannot be kept, the new group does not get its permissions.
TEST_P(AtomicFile, WhoMayNotGiveItAwayDoesNotOpenItEither)
{
    if (::geteuid() != 0)
        GTEST_SKIP() << "only root can set this up";
    ASSERT_EQ(::chmod((folder / "").c_str(), 0777), 0);
    test::write_text(path, "old");
    ASSERT_EQ(::chown(path.c_str(), 65'000, 65'001), 0);
    ASSERT_EQ(::chmod(path.c_str(), 0666 & ~0004), 0); // group: read and write; others: write
    const int status = test::status_in_child([&] {
        if (::setgid(65'003) != 0 || ::setuid(65'002) != 0 || ::access(path.c_str(), W_OK) != 0)
            return 77;
        return replace(path, "new") ? 0 : 1;
    });
    if (status == 77)
        GTEST_SKIP() << "other users cannot reach the temporary folder";
    EXPECT_EQ(status, 0);
    EXPECT_EQ(status_of(path).st_uid, 65'002U);
    EXPECT_EQ(status_of(path).st_gid, 65'003U);
    EXPECT_EQ(status_of(path).st_mode & 07777U, 0622U);
    EXPECT_EQ(test::read_text(path), "new");
}

/// Returns "user::rw-, user:65000:rw-, group::---, mask::rw-, other::---" in the kernel's format.
TEST_P(AtomicFile, AnAccessListStays)
{
    constexpr const char* attribute = "system.posix_acl_access";
    const std::array<std::uint8_t, 44> list = {
        2,    0, 0,    0,                         // version
        0x01, 0, 0x06, 0, 0xFF, 0xFF, 0xFF, 0xFF, // owner
        0x02, 0, 0x06, 0, 0xE8, 0xFD, 0,    0,    // user 65000
        0x04, 0, 0,    0, 0xFF, 0xFF, 0xFF, 0xFF, // group
        0x10, 0, 0x06, 0, 0xFF, 0xFF, 0xFF, 0xFF, // mask
        0x20, 0, 0,    0, 0xFF, 0xFF, 0xFF, 0xFF, // others
    };
    test::write_text(path, "old");
    if (::setxattr(path.c_str(), attribute, list.data(), list.size(), 0) != 0)
        GTEST_SKIP() << "the temporary folder's file system has no access lists: "
                     << std::strerror(errno);
    ASSERT_TRUE(replace(path, "new"));
    std::array<std::uint8_t, 100> kept{};
    ASSERT_EQ(::getxattr(path.c_str(), attribute, kept.data(), kept.size()), 44);
    EXPECT_EQ(std::memcmp(kept.data(), list.data(), list.size()), 0);
    EXPECT_EQ(status_of(path).st_mode & 07777U, 0660U);
}

TEST_P(AtomicFile, AFolderGivesItsGroup)
{
    fs::create_directory(folder / "shared");
    if (::geteuid() == 0) {
        ASSERT_EQ(::chown((folder / "shared").c_str(), 0, 65'001), 0);
    }
    ASSERT_EQ(::chmod((folder / "shared").c_str(), 02775), 0);
    const gid_t group = status_of(folder / "shared").st_gid;
    ASSERT_TRUE(replace(folder / "shared/file", "new"));
    EXPECT_EQ(status_of(folder / "shared/file").st_gid, group);
    ASSERT_TRUE(replace(folder / "shared/file", "newer"));
    EXPECT_EQ(status_of(folder / "shared/file").st_gid, group);
}

TEST_P(AtomicFile, AFileThatMustNotBeWrittenStays)
{
    test::write_text(path, "mine");
    ASSERT_EQ(::chmod(path.c_str(), 0444), 0);
    ASSERT_EQ(::chmod((folder / "").c_str(), 0777), 0);
    EXPECT_EQ(test::status_in_child([&] {
                  if (::geteuid() == 0 && (::setgid(65'003) != 0 || ::setuid(65'002) != 0))
                      return 1;
                  const auto result = replace(path, "x");
                  return !result && result.error().number == EACCES ? 0 : 2;
              }),
              0);
    EXPECT_EQ(test::read_text(path), "mine");
    EXPECT_EQ(names_in(folder / ""), Names{"file"});
}

TEST_P(AtomicFile, OtherNamesOfTheFileKeepTheOldContent)
{
    test::write_text(path, "old");
    fs::create_hard_link(path, folder / "other");
    ASSERT_TRUE(replace(path, "new"));
    EXPECT_EQ(test::read_text(path), "new");
    EXPECT_EQ(test::read_text(folder / "other"), "old");
}

TEST_P(AtomicFile, NamesMayBeAsLongAsTheFileSystemTakes)
{
    for (const std::size_t length : {200U, 251U, 252U, 253U, 254U, 255U}) {
        for (const std::string& ending : {std::string(), std::string(".png")}) {
            const std::string name = folder / (std::string(length - ending.size(), 'n') + ending);
            ASSERT_TRUE(replace(name, "first")) << length;
            ASSERT_TRUE(replace(name, "second")) << length;
            EXPECT_EQ(test::read_text(name), "second");
        }
    }
    // One long name is nearly all ending; the letters of the other have two bytes each.
    ASSERT_TRUE(replace(folder / ("." + std::string(254, 'e')), "x"));
    std::string letters;
    for (int i = 0; i < 127; ++i)
        letters += "\xC3\xA4";
    ASSERT_TRUE(replace(folder / letters, "x"));
    EXPECT_EQ(names_in(folder / "").size(), 14U);
    const auto result = replace(folder / std::string(256, 'n'), "x");
    ASSERT_FALSE(result);
    EXPECT_EQ(result.error().number, ENAMETOOLONG);
}

TEST_P(AtomicFile, FilesOfOthersBesideItStay)
{
    const Names others = {".file",    ".file.new", ".raymarch-1-1", "file.bak",
                          "file.new", "file.tmp",  "file~"};
    for (const std::string& name : others)
        test::write_text(folder / name, name);
    fs::create_symlink("file.new", folder / "file.old");
    ASSERT_TRUE(replace(path, "new"));
    for (const std::string& name : others)
        EXPECT_EQ(test::read_text(folder / name), name);
    EXPECT_TRUE(fs::is_symlink(folder / "file.old"));
    EXPECT_EQ(names_in(folder / "").size(), others.size() + 2);
}

TEST_P(AtomicFile, WhatAKilledRunLeftIsNoObstacle)
{
    for (int round = 0; round < 150; ++round) // more than the number of attempts
        ASSERT_EQ(test::status_in_child([&] {
                      auto left = TemporaryFile::open(path);
                      const bool written = left && left->write(as_bytes("half"));
                      if (written)
                          ::_exit(0); // no destructor runs, as after a kill
                      return 1;
                  }),
                  0);
    EXPECT_EQ(names_in(folder / "").size(), 150U);
    ASSERT_TRUE(replace(path, "new"));
    EXPECT_EQ(test::read_text(path), "new");
    EXPECT_EQ(names_in(folder / "").size(), 151U);
}

TEST_P(AtomicFile, OnAFullDiskTheOldOneStays)
{
    test::write_text(path, "old");
    {
        const test::FileSizeLimit limit(1000);
        const auto result = replace(path, std::string(2000, 'x'));
        ASSERT_FALSE(result);
        EXPECT_EQ(result.error().kind, ErrorKind::InputOutput);
        EXPECT_NE(result.error().message.find(path), std::string::npos);
        EXPECT_FALSE(replace(folder / "fresh", std::string(2000, 'x')));
    }
    EXPECT_EQ(test::read_text(path), "old");
    EXPECT_EQ(names_in(folder / ""), Names{"file"});
}

std::string whole(int writer)
{
    return std::string(10'000, static_cast<char>('a' + writer));
}

bool is_whole(const std::string& text)
{
    return text.size() == 10'000 && text == std::string(10'000, text[0]);
}

TEST_P(AtomicFile, WritersAtOnceNeverTearItAndNeverFail)
{
    constexpr int writers = 4;
    constexpr int rounds = 50;
    ASSERT_TRUE(replace(path, whole(0)));
    const auto write = [&](int writer) {
        int failures = 0;
        for (int round = 0; round < rounds; ++round)
            failures += replace(path, whole(writer)) ? 0 : 1;
        return failures;
    };
    std::vector<pid_t> children;
    for (int writer = 0; writer < writers; ++writer)
        children.push_back(test::start_child([&] { return write(writer); }));
    std::array<int, writers> failures{};
    std::vector<std::thread> threads;
    for (int writer = 0; writer < writers; ++writer)
        threads.emplace_back([&, writer] {
            failures.at(static_cast<std::size_t>(writer)) = write(writers + writer);
        });
    for (int look = 0; look < 200; ++look)
        ASSERT_TRUE(is_whole(test::read_text(path)));
    for (std::thread& thread : threads)
        thread.join();
    EXPECT_EQ(failures, (std::array<int, writers>{}));
    for (const pid_t child : children)
        EXPECT_EQ(test::status_of_child(child), 0);
    EXPECT_TRUE(is_whole(test::read_text(path)));
    EXPECT_EQ(names_in(folder / ""), Names{"file"});
}

} // namespace
} // namespace raymarch::drivers
