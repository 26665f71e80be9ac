// SPDX-License-Identifier: MIT
/// @file
/// Who may use what the service makes: the group of its unit may talk to it and see its picture,
/// whatever umask it was started with.
#include "service/support.hpp"

#include <gtest/gtest.h>

#include <sys/stat.h>
#include <unistd.h>

#include <filesystem>

namespace raymarch::tests
{
namespace
{

unsigned mode_of(const std::string& path)
{
    struct stat info = {};
    EXPECT_EQ(::stat(path.c_str(), &info), 0) << path;
    EXPECT_EQ(info.st_gid, ::getegid()) << path;
    return info.st_mode & 07777U;
}

TEST(Rights, TerminalAndSocketAreTheGroups)
{
    for (const char* const umask : {"0077", "0027", "0000"}) {
        const TemporaryFolder folder;
        const Service service(folder, {}, {}, std::string("umask ") + umask + "; exec \"$@\"");
        ASSERT_TRUE(service.ready());
        EXPECT_EQ(mode_of(service.terminal()), 0660U) << umask;
        EXPECT_EQ(mode_of(service.control()), 0660U) << umask;
    }
}

/// With the umask of the unit.
TEST(Rights, ThePreviewMayBeReadByTheGroup)
{
    const TemporaryFolder folder;
    const std::string preview = folder / "now.png";
    const Service service(
        folder, {"--registers", "emulated", "--emulated-size", "16x12", "--preview", preview}, {},
        "umask 0027; exec \"$@\"");
    ASSERT_TRUE(service.ready());
    ASSERT_TRUE(eventually([&] { return std::filesystem::exists(preview); }));
    EXPECT_EQ(mode_of(preview), 0640U);
}

} // namespace
} // namespace raymarch::tests
