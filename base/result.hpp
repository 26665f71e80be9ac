// SPDX-License-Identifier: MIT
/// @file
/// Expected failures: what went wrong, with the errno and a sentence for a person.
///
/// Bugs are asserted; everything the world can do to us travels as a Result.
#pragma once

#include <string>
#include <tl/expected.hpp>

namespace raymarch
{

/// What kind of failure it is; decides the exit status of a program (sysexits.h).
enum class ErrorKind {
    Usage,       ///< the command line is wrong
    BadData,     ///< input data is wrong
    Unavailable, ///< a device, file or service is not there (yet)
    InputOutput, ///< reading or writing failed
    Config,      ///< the configuration file is wrong
};

/// One failure. `number` is the errno, or 0 where there is none.
struct Error
{
    ErrorKind kind;
    int number;
    std::string message; ///< names what, where and, where it helps, what is allowed
};

template <typename T>
using Result = tl::expected<T, Error>;

/// An Error from the present errno: "<operation> <subject>: <strerror>". Call it before anything
/// else can change errno.
[[nodiscard]] Error errno_error(ErrorKind kind, const char* operation, const std::string& subject);

/// An Error without an errno.
[[nodiscard]] inline Error plain_error(ErrorKind kind, std::string message)
{
    return Error{kind, 0, std::move(message)};
}

[[nodiscard]] inline tl::unexpected<Error> fail(Error error)
{
    return tl::unexpected<Error>(std::move(error));
}

/// The sysexits status for an error: 64, 65, 69, 74 or 78.
[[nodiscard]] int exit_status(ErrorKind kind) noexcept;

} // namespace raymarch
