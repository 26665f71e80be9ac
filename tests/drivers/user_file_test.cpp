// SPDX-License-Identifier: MIT
#include "drivers/user_file.hpp"

#include "base/unique_fd.hpp"
#include "drivers/atomic_file.hpp"
#include "tests/fakes/child.hpp"
#include "tests/fakes/fifo.hpp"
#include "tests/fakes/special_files.hpp"
#include "tests/fakes/temporary_folder.hpp"

#include <gtest/gtest.h>

#include <fcntl.h>
#include <stdlib.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <filesystem>
#include <future>
#include <string>
#include <thread>
#include <vector>

namespace raymarch::drivers
{
namespace
{

namespace fs = std::filesystem;
using test::names_in;
using Names = std::vector<std::string>;

constexpr std::size_t limit = 1 << 22;
const std::string large(300'000, 'x'); ///< more than a pipe holds

Result<void> write(const std::string& path, std::string_view text)
{
    return write_output(path, as_bytes(text));
}

std::string by_descriptor(int fd)
{
    return "/dev/fd/" + std::to_string(fd);
}

struct Pipe
{
    Pipe()
    {
        std::array<int, 2> ends{};
        if (::pipe2(ends.data(), O_CLOEXEC) != 0)
            throw std::runtime_error("no pipe");
        reading = UniqueFd(ends[0]);
        writing = UniqueFd(ends[1]);
    }
    UniqueFd reading;
    UniqueFd writing;
};

TEST(WriteOutput, AFileIsReplaced)
{
    const test::TemporaryFolder folder;
    test::write_text(folder / "old", "");
    fs::permissions(folder / "old", fs::perms::owner_read | fs::perms::owner_write);
    fs::create_symlink("old", folder / "link");
    ASSERT_TRUE(write(folder / "link", "new"));
    EXPECT_EQ(test::read_text(folder / "old"), "new");
    EXPECT_EQ(test::status_of(folder / "old").st_mode & 07777U, 0600U);
    ASSERT_TRUE(write(folder / "fresh", "first"));
    EXPECT_EQ(test::read_text(folder / "fresh"), "first");
    EXPECT_EQ(names_in(folder / ""), (Names{"fresh", "link", "old"}));
}

TEST(WriteOutput, ADeviceTakesIt)
{
    const test::TemporaryFolder folder;
    const std::string null = test::spare_device(folder / "", "null");
    const std::string full = test::spare_device(folder / "", "full");
    if (null.empty() || full.empty())
        GTEST_SKIP() << "no device can be made here";
    ASSERT_TRUE(write(null, large));
    EXPECT_TRUE(fs::is_character_file(null));
    fs::create_symlink(null, folder / "link");
    ASSERT_TRUE(write(folder / "link", large));
    EXPECT_TRUE(fs::is_symlink(folder / "link"));
    EXPECT_TRUE(fs::is_character_file(null));
    const auto refused = write(full, "x");
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().number, ENOSPC);
    EXPECT_TRUE(fs::is_character_file(full));
}

TEST(WriteOutput, AFifoThatIsReadTakesIt)
{
    const test::TemporaryFolder folder;
    const test::Fifo fifo(folder / "fifo");
    const UniqueFd reading = test::open_unwritten(fifo.path);
    auto written = std::async(std::launch::async, [&] { return write(fifo.path, large); });
    EXPECT_EQ(test::read_to_end(reading.get()), large);
    EXPECT_TRUE(written.get());
    EXPECT_TRUE(fs::is_fifo(fifo.path));
    EXPECT_EQ(names_in(folder / ""), Names{"fifo"});
}

TEST(WriteOutput, AFifoThatNobodyReadsIsNotWaitedFor)
{
    const test::TemporaryFolder folder;
    const test::Fifo fifo(folder / "fifo");
    const auto result = write(fifo.path, "x");
    ASSERT_FALSE(result);
    EXPECT_EQ(result.error().kind, ErrorKind::InputOutput);
    EXPECT_EQ(result.error().message, fifo.path + " is a FIFO that nobody reads");
    EXPECT_TRUE(fs::is_fifo(fifo.path));
}

TEST(WriteOutput, WhatTakesNothingIsRefusedAlsoBeforeTheWork)
{
    const test::TemporaryFolder folder;
    const test::SpecialFiles special(folder / "");
    for (const auto& [name, what] : special.all()) {
        const bool takes = name == "fifo" || name == "null";
        EXPECT_EQ(check_output(folder / name).has_value(), takes) << name;
        if (takes)
            continue;
        const auto result = write(folder / name, "x");
        ASSERT_FALSE(result) << name;
        EXPECT_EQ(result.error().message, folder / name + " is " + what + ", not a file");
    }
    EXPECT_TRUE(check_output(folder / "fresh"));
    EXPECT_TRUE(check_output("/dev/null"));
    EXPECT_EQ(names_in(folder / ""), special.names());
}

/// A shell's >(...) gives such a name. It leads to a pipe that is already open.
TEST(WriteOutput, ADescriptorIsWrittenWhereItStands)
{
    Pipe pipe;
    ASSERT_TRUE(write(by_descriptor(pipe.writing.get()), "through a pipe"));
    pipe.writing.reset();
    EXPECT_EQ(test::read_to_end(pipe.reading.get()), "through a pipe");

    const test::TemporaryFolder folder;
    const std::string path = folder / "log";
    test::write_text(path, "");
    UniqueFd log(::open(path.c_str(), O_RDWR | O_CLOEXEC));
    for (const std::string& name :
         {by_descriptor(log.get()), "/proc/self/fd/" + std::to_string(log.get())}) {
        ASSERT_EQ(::write(log.get(), "before ", 7), 7);
        ASSERT_TRUE(write(name, "output "));
        ASSERT_EQ(::write(log.get(), "after\n", 6), 6);
    }
    EXPECT_EQ(test::read_text(path), "before output after\nbefore output after\n");
    fs::remove(path); // it also works when the file has no name
    ASSERT_TRUE(write(by_descriptor(log.get()), "x"));
    EXPECT_EQ(::lseek(log.get(), 0, SEEK_CUR), 41);
    EXPECT_EQ(names_in(folder / ""), Names{});

    const auto closed = write("/dev/fd/987", "x");
    ASSERT_FALSE(closed);
    EXPECT_EQ(closed.error().number, EBADF);
}

/// Runs `body` in a child process with `fd` as standard output.
template <typename Body>
int with_standard_output(int fd, Body body)
{
    return test::status_in_child([&] {
        ::dup2(fd, STDOUT_FILENO);
        return body();
    });
}

TEST(WriteOutput, AMinusAndDevStdoutAreStandardOutput)
{
    for (const char* const name : {"-", "/dev/stdout"}) {
        Pipe pipe;
        EXPECT_EQ(with_standard_output(pipe.writing.get(),
                                       [&] {
                                           std::printf("printed, ");
                                           return check_output(name) && write(name, "written") ? 0
                                                                                               : 1;
                                       }),
                  0);
        pipe.writing.reset();
        EXPECT_EQ(test::read_to_end(pipe.reading.get()), "printed, written") << name;
    }
    EXPECT_FALSE(fs::exists("-"));
}

TEST(WriteOutput, ATerminalDoesNotGetBytesForPrograms)
{
    const UniqueFd terminal(::posix_openpt(O_RDWR | O_NOCTTY | O_CLOEXEC));
    ASSERT_TRUE(terminal && ::grantpt(terminal.get()) == 0 && ::unlockpt(terminal.get()) == 0);
    std::array<char, 64> name{};
    ASSERT_EQ(::ptsname_r(terminal.get(), name.data(), name.size()), 0);
    const UniqueFd other_end(::open(name.data(), O_RDWR | O_NOCTTY | O_CLOEXEC));
    ASSERT_TRUE(other_end);
    EXPECT_EQ(with_standard_output(other_end.get(),
                                   [] {
                                       const auto result = write("-", "x");
                                       return !result && result.error().kind == ErrorKind::Usage
                                                  ? 0
                                                  : 1;
                                   }),
              0);
}

TEST(ReadInput, AFileIsReadUpToItsLimit)
{
    const test::TemporaryFolder folder;
    test::write_text(folder / "file", large);
    EXPECT_EQ(read_input(folder / "file", limit).value(), large);
    EXPECT_FALSE(read_input(folder / "file", large.size() - 1));
    const auto missing = read_input(folder / "none", limit);
    ASSERT_FALSE(missing);
    EXPECT_EQ(missing.error().number, ENOENT);
}

TEST(ReadInput, ADescriptorIsReadFromWhereItStands)
{
    const test::TemporaryFolder folder;
    test::write_text(folder / "file", "a head and the rest");
    const UniqueFd file(::open((folder / "file").c_str(), O_RDONLY | O_CLOEXEC));
    ASSERT_EQ(::lseek(file.get(), 11, SEEK_SET), 11);
    EXPECT_EQ(read_input(by_descriptor(file.get()), limit).value(), "the rest");

    Pipe pipe;
    std::thread writer([&] {
        static_cast<void>(write(by_descriptor(pipe.writing.get()), large));
        pipe.writing.reset();
    });
    const auto content = read_input(by_descriptor(pipe.reading.get()), limit);
    writer.join();
    EXPECT_EQ(content.value(), large);
}

TEST(ReadInput, AMinusAndDevStdinAreStandardInput)
{
    for (const char* const name : {"-", "/dev/stdin"}) {
        Pipe pipe;
        ASSERT_TRUE(write(by_descriptor(pipe.writing.get()), "typed"));
        pipe.writing.reset();
        EXPECT_EQ(test::status_in_child([&] {
                      ::dup2(pipe.reading.get(), STDIN_FILENO);
                      const auto content = read_input(name, limit);
                      return content && *content == "typed" ? 0 : 1;
                  }),
                  0)
            << name;
    }
    EXPECT_EQ(input_name("-"), "standard input");
    EXPECT_EQ(input_name("a"), "a");
}

TEST(ReadInput, ADeviceIsRead)
{
    EXPECT_EQ(read_input("/dev/null", limit).value(), "");
    const auto endless = read_input("/dev/zero", 10'000);
    ASSERT_FALSE(endless);
    EXPECT_EQ(endless.error().kind, ErrorKind::BadData);
    EXPECT_EQ(endless.error().message, "/dev/zero has more than 10000 bytes");
}

/// The writer comes late and stops in between. The input ends when the writer closes the FIFO.
TEST(ReadInput, AFifoIsReadToItsWritersEnd)
{
    const test::TemporaryFolder folder;
    const test::Fifo fifo(folder / "fifo");
    auto content = std::async(std::launch::async, [&] { return read_input(fifo.path, limit); });
    UniqueFd writing = test::open_once_read(fifo.path);
    ASSERT_TRUE(writing);
    for (int part = 0; part < 3; ++part) {
        ASSERT_EQ(::write(writing.get(), large.data(), 100'000), 100'000);
        std::this_thread::yield(); // lets the reader run
    }
    writing.reset();
    EXPECT_EQ(content.get().value(), large);
}

TEST(ReadInput, AWriterThatWritesNothingIsAnEmptyInput)
{
    const test::TemporaryFolder folder;
    const test::Fifo fifo(folder / "fifo");
    auto content = std::async(std::launch::async, [&] { return read_input(fifo.path, limit); });
    ASSERT_TRUE(test::open_once_read(fifo.path)); // it is also closed again
    EXPECT_EQ(content.get().value(), "");
}

TEST(ReadInput, AFifoThatNobodyWritesToIsGivenUp)
{
    const test::TemporaryFolder folder;
    const test::Fifo fifo(folder / "fifo");
    const auto result = read_input(fifo.path, limit);
    ASSERT_FALSE(result);
    EXPECT_EQ(result.error().kind, ErrorKind::InputOutput);
    EXPECT_EQ(result.error().message, fifo.path + " is a FIFO that nobody writes to");
}

TEST(ReadInput, WhatCannotBeReadIsRefused)
{
    const test::TemporaryFolder folder;
    const test::SpecialFiles special(folder / "");
    for (const auto& [name, what] : special.all()) {
        if (name == "fifo" || name == "null")
            continue;
        const auto result = read_input(folder / name, limit);
        ASSERT_FALSE(result) << name;
        EXPECT_EQ(result.error().message, folder / name + " is " + what + ", not a file");
    }
}

} // namespace
} // namespace raymarch::drivers
