// SPDX-License-Identifier: MIT
/// @file
/// FIFOs for tests: a name, and its ends, opened without waiting for ever.
#pragma once

#include "base/unique_fd.hpp"
#include "tests/fakes/waiting.hpp"

#include <fcntl.h>
#include <sys/stat.h>

#include <array>
#include <chrono>
#include <stdexcept>
#include <string>
#include <thread>

namespace raymarch::test
{

struct Fifo
{
    explicit Fifo(std::string name) : path(std::move(name))
    {
        if (::mkfifo(path.c_str(), 0600) != 0)
            throw std::runtime_error("no FIFO " + path);
    }
    std::string path;
};

/// The writing end, once somebody reads; none when nobody does.
[[nodiscard]] inline UniqueFd open_once_read(const std::string& fifo)
{
    using Clock = std::chrono::steady_clock;
    const auto deadline = Clock::now() + std::chrono::milliseconds(patience_ms);
    UniqueFd fd;
    while (!fd && Clock::now() < deadline) {
        fd = UniqueFd(::open(fifo.c_str(), O_WRONLY | O_NONBLOCK | O_CLOEXEC));
        if (!fd)
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    if (fd && ::fcntl(fd.get(), F_SETFL, 0) != 0)
        fd.reset();
    return fd;
}

/// The reading end, before anybody writes; reading from it waits.
[[nodiscard]] inline UniqueFd open_unwritten(const std::string& fifo)
{
    UniqueFd fd(::open(fifo.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC));
    if (fd && ::fcntl(fd.get(), F_SETFL, 0) != 0)
        fd.reset();
    return fd;
}

/// What a writer writes until it ends; it is waited for.
[[nodiscard]] inline std::string read_to_end(int fd)
{
    std::string content;
    std::array<char, 4096> chunk{};
    if (!readable(fd)) // until the writer is there it is at its end
        return content;
    for (;;) {
        const ssize_t size = ::read(fd, chunk.data(), chunk.size());
        if (size <= 0)
            return content;
        content.append(chunk.data(), static_cast<std::size_t>(size));
    }
}

} // namespace raymarch::test
