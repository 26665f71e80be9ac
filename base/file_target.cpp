// SPDX-License-Identifier: MIT
#include "base/file_target.hpp"

#include <array>
#include <cerrno>
#include <filesystem>
#include <string_view>
#include <system_error>

namespace raymarch
{
namespace
{

namespace fs = std::filesystem;

/// The kernel appends this to the /proc link of an open file that was removed.
constexpr std::string_view deleted_suffix = " (deleted)";

struct TypeName
{
    mode_t type;
    const char* name;
};
constexpr std::array type_names = {
    TypeName{S_IFDIR, "a folder"},           TypeName{S_IFIFO, "a FIFO"},
    TypeName{S_IFCHR, "a character device"}, TypeName{S_IFBLK, "a block device"},
    TypeName{S_IFSOCK, "a socket"},          TypeName{S_IFLNK, "a symbolic link"},
};

const char* type_name(mode_t mode) noexcept
{
    for (const TypeName& row : type_names)
        if (row.type == (mode & S_IFMT))
            return row.name;
    return "something else";
}

} // namespace

Error not_a_file(const std::string& path, mode_t mode)
{
    return plain_error(ErrorKind::InputOutput, path + " is " + type_name(mode) + ", not a file");
}

std::string end_of_links(const std::string& path)
{
    fs::path end = path;
    for (int links = 0; links < most_links; ++links) {
        std::error_code no_link;
        const fs::path next = fs::read_symlink(end, no_link);
        if (no_link)
            break;
        end = end.parent_path() / next;
    }
    return end.string();
}

Result<FileTarget> find_target(const std::string& path)
{
    struct stat file = {};
    const bool there = ::stat(path.c_str(), &file) == 0;
    if (!there && errno != ENOENT)
        return fail(errno_error(ErrorKind::InputOutput, "look at", path));
    if (there && !S_ISREG(file.st_mode))
        return fail(not_a_file(path, file.st_mode));
    FileTarget target{.path = end_of_links(path), .file = std::nullopt};
    // The link is checked again, because another process may have replaced it meanwhile.
    if (::lstat(target.path.c_str(), &file) == 0)
        target.file = file;
    else if (there && target.path.ends_with(deleted_suffix))
        return fail(
            plain_error(ErrorKind::InputOutput,
                        path + " is an open file without a name, which cannot be replaced"));
    return target;
}

} // namespace raymarch
