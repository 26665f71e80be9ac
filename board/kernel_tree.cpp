// SPDX-License-Identifier: MIT
#include "board/kernel_tree.hpp"

#include "base/unique_fd.hpp"
#include "drivers/atomic_file.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <filesystem>

namespace raymarch::board
{

namespace fs = std::filesystem;

namespace
{

constexpr std::size_t largest_file = 65'536; ///< a sysfs file has at most one page

} // namespace

std::string KernelTree::path(std::string_view file) const
{
    return (fs::path(root_) / file).string();
}

std::string KernelTree::beside(std::string_view folder) const
{
    std::error_code error;
    const fs::path root = fs::absolute(root_, error);
    return (root / ".." / folder).lexically_normal().string();
}

bool KernelTree::exists(std::string_view file) const
{
    std::error_code error;
    return fs::exists(path(file), error);
}

std::vector<std::string> KernelTree::entries(std::string_view folder) const
{
    std::vector<std::string> names;
    std::error_code error;
    for (fs::directory_iterator entry(path(folder), error), end; !error && entry != end;
         entry.increment(error))
        names.push_back(entry->path().filename().string());
    std::ranges::sort(names);
    return names;
}

std::optional<std::string> KernelTree::line(std::string_view file) const
{
    const auto content = drivers::read_file(path(file), largest_file);
    if (!content || content->empty())
        return std::nullopt;
    return content->substr(0, content->find('\n'));
}

std::optional<std::uint64_t> KernelTree::hex(std::string_view file) const
{
    const auto text = line(file);
    if (!text)
        return std::nullopt;
    const std::size_t digits = text->starts_with("0x") ? 2 : 0;
    const char* const end = text->data() + text->size();
    std::uint64_t value = 0;
    const auto [stop, error] = std::from_chars(text->data() + digits, end, value, 16);
    if (error != std::errc{} || stop != end)
        return std::nullopt;
    return value;
}

Result<void> KernelTree::write(std::string_view file, std::string_view bytes)
{
    const std::string name = path(file);
    UniqueFd fd(::open(name.c_str(), O_WRONLY | O_TRUNC | O_NONBLOCK | O_NOCTTY | O_CLOEXEC));
    if (!fd)
        return fail(errno_error(ErrorKind::Unavailable, "open", name));
    const ssize_t written = ::write(fd.get(), bytes.data(), bytes.size());
    if (written < 0)
        return fail(errno_error(ErrorKind::InputOutput, "write", name));
    if (static_cast<std::size_t>(written) != bytes.size())
        return fail(plain_error(ErrorKind::InputOutput, name + ": " + std::to_string(written) +
                                                            " of " + std::to_string(bytes.size()) +
                                                            " bytes were written"));
    if (::close(fd.release()) != 0)
        return fail(errno_error(ErrorKind::InputOutput, "write", name));
    return {};
}

Result<void> KernelTree::make_folder(std::string_view folder)
{
    if (::mkdir(path(folder).c_str(), 0755) != 0)
        return fail(errno_error(ErrorKind::InputOutput, "make", path(folder)));
    return {};
}

Result<void> KernelTree::remove_folder(std::string_view folder)
{
    if (::rmdir(path(folder).c_str()) != 0)
        return fail(errno_error(ErrorKind::InputOutput, "remove", path(folder)));
    return {};
}

} // namespace raymarch::board
