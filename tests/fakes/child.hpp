// SPDX-License-Identifier: MIT
/// @file
/// Part of a test in a process of its own: what it changes of the process (umask, user) or leaves
/// behind when it ends at once stays with it. The test has one thread when it is made.
#pragma once

#include <sys/wait.h>
#include <unistd.h>

namespace raymarch::test
{

/// `body` returns the exit status.
template <typename Body>
[[nodiscard]] pid_t start_child(Body body)
{
    const pid_t child = ::fork();
    if (child == 0)
        ::_exit(body());
    return child;
}

/// 128 + N when signal N ended it.
[[nodiscard]] inline int status_of_child(pid_t child)
{
    int raw = 0;
    if (::waitpid(child, &raw, 0) != child)
        return -1;
    return WIFEXITED(raw) ? WEXITSTATUS(raw) : 128 + WTERMSIG(raw);
}

template <typename Body>
[[nodiscard]] int status_in_child(Body body)
{
    return status_of_child(start_child(body));
}

} // namespace raymarch::test
