// SPDX-License-Identifier: MIT
#include "base/result.hpp"

#include <gtest/gtest.h>

#include <cerrno>

namespace raymarch
{
namespace
{

TEST(Result, ExitStatusesAreThoseOfSysexits)
{
    EXPECT_EQ(exit_status(ErrorKind::Usage), 64);
    EXPECT_EQ(exit_status(ErrorKind::BadData), 65);
    EXPECT_EQ(exit_status(ErrorKind::Unavailable), 69);
    EXPECT_EQ(exit_status(ErrorKind::InputOutput), 74);
    EXPECT_EQ(exit_status(ErrorKind::Config), 78);
}

TEST(Result, AnErrnoErrorNamesOperationSubjectAndReason)
{
    errno = ENOENT;
    const Error error = errno_error(ErrorKind::Unavailable, "open", "/a/file");
    EXPECT_EQ(error.kind, ErrorKind::Unavailable);
    EXPECT_EQ(error.number, ENOENT);
    EXPECT_EQ(error.message, "open /a/file: No such file or directory");
}

TEST(Result, APlainErrorHasNoErrno)
{
    errno = ENOENT;
    const Result<int> result = fail(plain_error(ErrorKind::BadData, "it is wrong"));
    ASSERT_FALSE(result);
    EXPECT_EQ(result.error().number, 0);
    EXPECT_EQ(result.error().message, "it is wrong");
}

} // namespace
} // namespace raymarch
