// SPDX-License-Identifier: MIT
#include "base/standard_descriptors.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <initializer_list>

namespace raymarch
{
namespace
{

/// Opens the lowest free descriptor; returns -1 if none can be opened.
int open_placeholder() noexcept
{
    const int null = ::open("/dev/null", O_RDWR | O_NOCTTY); // no O_CLOEXEC: children inherit it
    return null >= 0 ? null : ::open("/", O_PATH | O_DIRECTORY);
}

} // namespace

bool fill_standard_descriptors() noexcept
{
    for (const int standard : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
        if (::fcntl(standard, F_GETFD) < 0 && errno == EBADF && open_placeholder() != standard)
            return false;
    return true;
}

} // namespace raymarch
