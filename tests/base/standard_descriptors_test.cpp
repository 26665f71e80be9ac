// SPDX-License-Identifier: MIT
#include "base/standard_descriptors.hpp"

#include <gtest/gtest.h>

#include <fcntl.h>
#include <sched.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <functional>

namespace raymarch
{
namespace
{

bool is_null(int fd)
{
    struct stat info = {};
    struct stat null = {};
    return ::fstat(fd, &info) == 0 && ::stat("/dev/null", &null) == 0 &&
           info.st_rdev == null.st_rdev && S_ISCHR(info.st_mode);
}

/// Runs `act` in a child process. Returns its status, or -1.
int in_a_child(const std::function<int()>& act)
{
    const pid_t child = ::fork();
    if (child == 0)
        ::_exit(act());
    int status = 0;
    return ::waitpid(child, &status, 0) == child && WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

/// For each of the eight sets of 0, 1 and 2, the closed descriptors are opened, the open ones stay
/// as they are, and the next file gets another number.
TEST(StandardDescriptors, ThoseThatAreClosedAreFilled)
{
    for (unsigned closed = 0; closed < 8; ++closed) {
        const int status = in_a_child([closed] {
            for (int fd = 0; fd < 3; ++fd) {
                const int file = ::open("/proc/self/comm", O_RDONLY);
                ::dup2(file, fd);
                if (file > 2)
                    ::close(file);
            }
            for (int fd = 0; fd < 3; ++fd)
                if ((closed >> fd & 1) != 0)
                    ::close(fd);
            if (!fill_standard_descriptors())
                return 1;
            for (int fd = 0; fd < 3; ++fd)
                if (is_null(fd) != ((closed >> fd & 1) != 0))
                    return 2;
            for (int fd = 0; fd < 3; ++fd) // a child inherits them
                if ((::fcntl(fd, F_GETFD) & FD_CLOEXEC) != 0)
                    return 3;
            return ::open("/", O_RDONLY) > 2 ? 0 : 4;
        });
        EXPECT_EQ(status, 0) << "closed: " << closed;
    }
}

/// This test needs the permission to make a new root folder.
TEST(StandardDescriptors, AreFilledWithoutANullDeviceToo)
{
    const int status = in_a_child([] {
        if ((::geteuid() != 0 && ::unshare(CLONE_NEWUSER) != 0) ||
            ::chroot("/proc/self/fdinfo") != 0)
            return 77;
        for (int fd = 0; fd < 3; ++fd)
            ::close(fd);
        if (!fill_standard_descriptors())
            return 1;
        char byte = 'x';
        for (int fd = 0; fd < 3; ++fd) // it can be neither read nor written, and nothing waits
            if (::read(fd, &byte, 1) == 1 || ::write(fd, &byte, 1) == 1)
                return 2;
        return ::open("/", O_RDONLY) > 2 ? 0 : 3;
    });
    if (status == 77)
        GTEST_SKIP() << "chroot is not permitted";
    EXPECT_EQ(status, 0);
}

TEST(StandardDescriptors, WhenNoneIsAllowedItIsSaid)
{
    const int status = in_a_child([] {
        const rlimit none = {.rlim_cur = 0, .rlim_max = 0};
        ::close(1);
        return ::setrlimit(RLIMIT_NOFILE, &none) == 0 && !fill_standard_descriptors() ? 0 : 1;
    });
    EXPECT_EQ(status, 0);
}

} // namespace
} // namespace raymarch
