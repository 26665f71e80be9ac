// SPDX-License-Identifier: MIT
#include "drivers/lock_file.hpp"

#include "tests/fakes/other_process.hpp"
#include "tests/fakes/temporary_folder.hpp"

#include <gtest/gtest.h>

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>

#include <filesystem>
#include <optional>
#include <string>

namespace raymarch::drivers
{
namespace
{

namespace fs = std::filesystem;

class Lock : public testing::Test
{
  protected:
    /// Expects that the lock at `path` is held, by `holder` if that is given.
    static void expect_held(const Result<LockFile>& lock, const std::string& path,
                            std::optional<pid_t> holder = std::nullopt)
    {
        ASSERT_FALSE(lock);
        EXPECT_TRUE(held_by_another(lock.error())) << lock.error().message;
        EXPECT_EQ(exit_status(lock.error().kind), 69);
        const std::string who = holder ? "process " + std::to_string(*holder) + " (" : "process";
        EXPECT_TRUE(lock.error().message.starts_with(path + " is in use by "))
            << lock.error().message;
        EXPECT_NE(lock.error().message.find(who), std::string::npos) << lock.error().message;
    }
    test::TemporaryFolder folder;
    std::string path = folder / "thing.lock";
};

TEST_F(Lock, TheSecondHearsWhoHasIt)
{
    const test::OtherProcess other([&] { return LockFile::take(path); });
    ASSERT_TRUE(other.has_it());
    expect_held(LockFile::take(path), path, other.pid());
}

TEST_F(Lock, DoesNotOutliveAKilledHolder)
{
    test::OtherProcess other([&] { return LockFile::take(path); });
    ASSERT_TRUE(other.has_it());
    other.kill();
    EXPECT_TRUE(fs::exists(path)) << "it had no time to clean up";
    const auto lock = LockFile::take(path);
    EXPECT_TRUE(lock) << lock.error().message;
}

TEST_F(Lock, HoldsWithinOneProcessToo)
{
    auto first = LockFile::take(path);
    ASSERT_TRUE(first);
    expect_held(LockFile::take(path), path);
    expect_held(LockFile::take(path), path); // the failed attempt has not released it
    const LockFile moved = std::move(*first);
    expect_held(LockFile::take(path), path);
}

TEST_F(Lock, GoesWithItsHolder)
{
    {
        const auto lock = LockFile::take(path);
        ASSERT_TRUE(lock);
        EXPECT_EQ(fs::file_size(path), 0U);
    }
    EXPECT_FALSE(fs::exists(path));
    EXPECT_TRUE(LockFile::take(path));
}

TEST_F(Lock, OneThatIsReplacedByAnotherLeavesTheOthersFile)
{
    {
        const auto lock = LockFile::take(path);
        ASSERT_TRUE(lock);
        fs::remove(path);
        test::write_text(path, "somebody else's");
    }
    EXPECT_EQ(test::read_text(path), "somebody else's");
}

TEST_F(Lock, AFileThatWasThereKeepsWhatItHolds)
{
    test::write_text(path, "a note");
    EXPECT_TRUE(LockFile::take(path));
    EXPECT_EQ(test::read_text(path), "a note");
}

TEST_F(Lock, WhereThereCanBeNoneNobodyHoldsIt)
{
    fs::create_directory(folder / "folder");
    fs::create_symlink("elsewhere", folder / "link");
    ASSERT_EQ(::mkfifo((folder / "fifo").c_str(), 0600), 0);
    for (const char* const name : {"missing/thing.lock", "folder", "link", "fifo"}) {
        const auto lock = LockFile::take(folder / name);
        ASSERT_FALSE(lock) << name;
        EXPECT_FALSE(held_by_another(lock.error())) << lock.error().message;
        EXPECT_NE(lock.error().message.find(folder / name), std::string::npos);
    }
    EXPECT_FALSE(fs::exists(folder / "elsewhere"));
}

TEST_F(Lock, BesideAFileHasOneLockUnderEachOfItsNames)
{
    fs::create_directory(folder / "real");
    fs::create_symlink("real", folder / "alias");
    fs::create_symlink("real/state", folder / "link"); // the target does not exist yet
    const auto lock = LockFile::take_for(folder / "link");
    ASSERT_TRUE(lock) << lock.error().message;
    test::write_text(folder / "real/state", "it is there now");
    for (const char* const name : {"link", "real/state", "alias/state", "real/../alias/state"})
        expect_held(LockFile::take_for(folder / name), folder / name);
    EXPECT_TRUE(LockFile::take_for(folder / "real/another"));
}

TEST_F(Lock, WhatIsNoOrdinaryFileHasNoOwner)
{
    ASSERT_EQ(::mkfifo((folder / "fifo").c_str(), 0600), 0);
    for (const std::string& name : {std::string("/dev/null"), folder / "fifo"}) {
        const auto first = LockFile::take_for(name);
        const auto second = LockFile::take_for(name);
        EXPECT_TRUE(first && second) << name;
        EXPECT_FALSE(fs::exists(name + ".lock"));
    }
}

TEST_F(Lock, ADescriptorIsLockedWhateverItIsOpenFor)
{
    test::write_text(folder / "registers", "0123");
    const test::OtherProcess other([&] {
        UniqueFd fd(::open((folder / "registers").c_str(), O_RDONLY | O_CLOEXEC));
        return lock_descriptor(fd.release(), "registers").has_value();
    });
    ASSERT_TRUE(other.has_it());
    const UniqueFd fd(::open((folder / "registers").c_str(), O_RDWR | O_CLOEXEC));
    const auto locked = lock_descriptor(fd.get(), "the registers");
    ASSERT_FALSE(locked);
    EXPECT_TRUE(locked.error().message.starts_with("the registers is in use by process " +
                                                   std::to_string(other.pid()) + " ("))
        << locked.error().message;
}

/// A program such as flock(1) locks with flock() and does not publish its process number.
TEST_F(Lock, AHolderThatDoesNotTellItsNameIsAnotherProcess)
{
    const UniqueFd holder(::open(path.c_str(), O_RDONLY | O_CREAT | O_CLOEXEC, 0600));
    ASSERT_EQ(::flock(holder.get(), LOCK_EX | LOCK_NB), 0);
    const auto lock = LockFile::take(path);
    ASSERT_FALSE(lock);
    EXPECT_EQ(lock.error().message, path + " is in use by another process");
}

} // namespace
} // namespace raymarch::drivers
