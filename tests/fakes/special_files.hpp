// SPDX-License-Identifier: MIT
/// @file
/// What can stand at a path and is no file: made in a folder, for a test to try as input or output.
#pragma once

#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/sysmacros.h>
#include <sys/un.h>
#include <unistd.h>

#include <algorithm>
#include <cstring>
#include <map>
#include <stdexcept>
#include <string>
#include <vector>

namespace raymarch::test
{

/// Whatever is there; a link itself. Zeros where nothing is.
[[nodiscard]] inline struct stat status_of(const std::string& path)
{
    struct stat status = {};
    static_cast<void>(::lstat(path.c_str(), &status));
    return status;
}

/// A socket that nobody listens at.
inline void make_socket(const std::string& path)
{
    sockaddr_un address = {};
    address.sun_family = AF_UNIX;
    if (path.size() >= sizeof address.sun_path)
        throw std::runtime_error("too long for a socket: " + path);
    std::memcpy(address.sun_path, path.c_str(), path.size());
    const int fd = ::socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0);
    const int bound = ::bind(fd, reinterpret_cast<const sockaddr*>(&address), sizeof address);
    ::close(fd);
    if (bound != 0)
        throw std::runtime_error("no socket at " + path);
}

class SpecialFiles
{
  public:
    /// `folder` ends in a slash.
    explicit SpecialFiles(const std::string& folder)
    {
        if (::mkfifo((folder + "fifo").c_str(), 0600) != 0 ||
            ::mkdir((folder + "folder").c_str(), 0700) != 0)
            throw std::runtime_error("nothing can be made in " + folder);
        make_socket(folder + "socket");
        all_ = {{"fifo", "a FIFO"}, {"folder", "a folder"}, {"socket", "a socket"}};
        // Only root may, and not in every container.
        if (::mknod((folder + "null").c_str(), S_IFCHR | 0600, makedev(1, 3)) == 0)
            all_["null"] = "a character device";
        if (::mknod((folder + "disk").c_str(), S_IFBLK | 0600, makedev(7, 250)) == 0)
            all_["disk"] = "a block device";
    }

    /// Name in the folder, and what a message calls it.
    [[nodiscard]] const std::map<std::string, std::string>& all() const noexcept { return all_; }
    [[nodiscard]] std::vector<std::string> names() const
    {
        std::vector<std::string> names;
        for (const auto& [name, what] : all_)
            names.push_back(name);
        return names;
    }

  private:
    std::map<std::string, std::string> all_;
};

} // namespace raymarch::test
