// SPDX-License-Identifier: MIT
#include "pictures/unfinished_file.hpp"

#include "base/unique_fd.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <filesystem>
#include <system_error>

namespace raymarch::pictures
{
namespace
{

namespace fs = std::filesystem;

/// What an earlier run left, killed in its midst, has a name of this kind: more than a few are
/// none.
constexpr int most_names = 100;

std::string hidden_name(const fs::path& final_path, int attempt)
{
    return (final_path.parent_path() /
            ("." + final_path.stem().string() + "." + std::to_string(::getpid()) + "-" +
             std::to_string(attempt) + final_path.extension().string()))
        .string();
}

/// The first free hidden name, taken by `make`, which leaves EEXIST in errno when it is not free.
Result<std::string> take_hidden_name(const std::string& final_path,
                                     bool (*make)(const std::string&))
{
    for (int attempt = 0; attempt < most_names; ++attempt) {
        std::string name = hidden_name(final_path, attempt);
        if (make(name))
            return name;
        if (errno != EEXIST)
            break;
    }
    return fail(errno_error(ErrorKind::InputOutput, "make a file beside", final_path));
}

} // namespace

Result<Unfinished> Unfinished::file(const std::string& final_path)
{
    auto name = take_hidden_name(final_path, [](const std::string& path) {
        return static_cast<bool>(
            UniqueFd(::open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666)));
    });
    if (!name)
        return fail(name.error());
    return Unfinished(*std::move(name));
}

Result<Unfinished> Unfinished::folder(const std::string& final_path)
{
    auto name = take_hidden_name(
        final_path, [](const std::string& path) { return ::mkdir(path.c_str(), 0777) == 0; });
    if (!name)
        return fail(name.error());
    return Unfinished(*std::move(name));
}

Unfinished& Unfinished::operator=(Unfinished&& other) noexcept
{
    std::swap(path_, other.path_);
    return *this;
}

Unfinished::~Unfinished()
{
    if (path_.empty())
        return;
    std::error_code ignored; // published, or nothing that could be done about it
    fs::remove_all(path_, ignored);
}

Result<void> publish(const std::string& from, const std::string& final_path)
{
    if (std::rename(from.c_str(), final_path.c_str()) != 0)
        return fail(errno_error(ErrorKind::InputOutput, "replace", final_path));
    return {};
}

Result<OutputFile> OutputFile::open(const std::string& path, std::string name)
{
    File file(std::fopen(path.c_str(), "wbe"));
    if (!file)
        return fail(errno_error(ErrorKind::InputOutput, "make", name));
    return OutputFile(std::move(file), std::move(name));
}

Result<void> OutputFile::write(std::span<const std::uint8_t> bytes)
{
    if (std::fwrite(bytes.data(), 1, bytes.size(), file_.get()) != bytes.size())
        return fail(errno_error(ErrorKind::InputOutput, "write", name_));
    return {};
}

Result<void> OutputFile::close()
{
    if (std::fclose(file_.release()) != 0)
        return fail(errno_error(ErrorKind::InputOutput, "write", name_));
    return {};
}

} // namespace raymarch::pictures
