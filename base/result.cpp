// SPDX-License-Identifier: MIT
#include "base/result.hpp"

#include <sysexits.h>

#include <cerrno>
#include <system_error>

namespace raymarch
{

Error errno_error(ErrorKind kind, const char* operation, const std::string& subject)
{
    const int number = errno;
    return Error{kind, number,
                 std::string(operation) + " " + subject + ": " +
                     std::generic_category().message(number)};
}

int exit_status(ErrorKind kind) noexcept
{
    switch (kind) {
    case ErrorKind::Usage:
        return EX_USAGE;
    case ErrorKind::BadData:
        return EX_DATAERR;
    case ErrorKind::Unavailable:
        return EX_UNAVAILABLE;
    case ErrorKind::InputOutput:
        return EX_IOERR;
    case ErrorKind::Config:
        return EX_CONFIG;
    }
    return EX_SOFTWARE;
}

} // namespace raymarch
