// SPDX-License-Identifier: MIT
#include "base/unique_fd.hpp"

#include <gtest/gtest.h>

#include <fcntl.h>
#include <sys/eventfd.h>

#include <utility>

namespace raymarch
{
namespace
{

bool is_open(int fd)
{
    return ::fcntl(fd, F_GETFD) != -1;
}

UniqueFd make()
{
    return UniqueFd(::eventfd(0, EFD_CLOEXEC));
}

TEST(UniqueFd, NoneByDefault)
{
    const UniqueFd none;
    EXPECT_FALSE(none);
    EXPECT_EQ(none.get(), -1);
}

TEST(UniqueFd, ClosesItsDescriptor)
{
    int number = -1;
    {
        const UniqueFd fd = make();
        number = fd.get();
        EXPECT_TRUE(is_open(number));
    }
    EXPECT_FALSE(is_open(number));
}

TEST(UniqueFd, MovingHandsItOver)
{
    UniqueFd first = make();
    const int number = first.get();
    UniqueFd second(std::move(first));
    EXPECT_FALSE(first); // NOLINT(bugprone-use-after-move): that is the promise
    EXPECT_EQ(second.get(), number);
    EXPECT_TRUE(is_open(number));
}

TEST(UniqueFd, AssigningClosesTheOldOne)
{
    UniqueFd first = make();
    UniqueFd second = make();
    const int closed = first.get();
    const int kept = second.get();
    first = std::move(second);
    EXPECT_EQ(first.get(), kept);
    EXPECT_FALSE(is_open(closed));
    EXPECT_TRUE(is_open(kept));
}

TEST(UniqueFd, AssigningItToItselfKeepsIt)
{
    UniqueFd fd = make();
    UniqueFd& same = fd;
    fd = std::move(same);
    EXPECT_TRUE(is_open(fd.get()));
}

} // namespace
} // namespace raymarch
