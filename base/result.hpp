// SPDX-License-Identifier: MIT
/// @file
/// Expected failures are returned as a Result. An assertion catches a bug.
#pragma once

#include <string>
#include <tl/expected.hpp>

namespace raymarch
{

/// The kind of a failure. It decides the exit status of a program (sysexits.h).
enum class ErrorKind {
    Usage,       ///< the command line is wrong
    BadData,     ///< input data is wrong
    Unavailable, ///< a device, file or service is not there (yet)
    InputOutput, ///< reading or writing failed
    Config,      ///< the configuration file is wrong
};

/// One failure. `number` is the errno, or 0 if there is none.
struct Error
{
    ErrorKind kind;
    int number;
    std::string message; ///< says what is wrong, where, and if it helps, what is allowed
};

template <typename T>
using Result = tl::expected<T, Error>;

/// Makes an Error from errno: "<operation> <subject>: <strerror>".
[[nodiscard]] Error errno_error(ErrorKind kind, const char* operation, const std::string& subject);

/// Makes an Error without an errno.
[[nodiscard]] inline Error plain_error(ErrorKind kind, std::string message)
{
    return Error{kind, 0, std::move(message)};
}

[[nodiscard]] inline tl::unexpected<Error> fail(Error error)
{
    return tl::unexpected<Error>(std::move(error));
}

/// Returns the exit status for an error, as sysexits.h defines it: 64, 65, 69, 74 or 78.
[[nodiscard]] int exit_status(ErrorKind kind) noexcept;

} // namespace raymarch
