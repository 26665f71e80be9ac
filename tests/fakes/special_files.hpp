// SPDX-License-Identifier: MIT
/// @file
/// What can stand at a path and is no file: made in a folder, for a test to try as input or output.
#pragma once

#include <fcntl.h>
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

/// A device that a test may try to replace. `null` and `full` are made in `folder`, which ends in a
/// slash, where that is permitted: root could destroy the machine's own. Others use those. Empty
/// where there is none.
[[nodiscard]] inline std::string spare_device(const std::string& folder, const std::string& name)
{
    if (::geteuid() != 0)
        return "/dev/" + name;
    const std::string path = folder + name;
    const unsigned minor = name == "null" ? 3 : 7;
    static_cast<void>(::mknod(path.c_str(), S_IFCHR | 0666, makedev(1, minor)));
    const int fd = ::open(path.c_str(), O_WRONLY | O_CLOEXEC); // not where devices are switched off
    if (fd < 0)
        return {};
    ::close(fd);
    return path;
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
