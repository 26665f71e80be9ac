// SPDX-License-Identifier: MIT
/// @file
/// Another process that holds something while the test looks, and ends when it is told to.
#pragma once

#include "base/unique_fd.hpp"

#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>

namespace raymarch::test
{

class OtherProcess
{
  public:
    /// Runs `begin` in a child, which then keeps what `begin` returned; the constructor returns
    /// when it has it. Between fork and the end of the child there are no other threads.
    template <typename Begin>
    explicit OtherProcess(Begin begin)
    {
        std::array<int, 2> ends{-1, -1};
        if (::pipe(ends.data()) != 0)
            return;
        const UniqueFd from(ends[0]);
        UniqueFd to(ends[1]);
        pid_ = ::fork();
        if (pid_ == 0) {
            const auto kept = begin();
            const char word = kept ? 'y' : 'n';
            static_cast<void>(::write(to.get(), &word, 1));
            for (;;)
                ::pause();
        }
        to.reset();
        char word = 'n';
        has_it_ = ::read(from.get(), &word, 1) == 1 && word == 'y';
    }
    OtherProcess(const OtherProcess&) = delete;
    OtherProcess& operator=(const OtherProcess&) = delete;
    ~OtherProcess() { kill(); }

    [[nodiscard]] bool has_it() const { return has_it_; }
    [[nodiscard]] pid_t pid() const { return pid_; }
    /// Ends it as kill -9 does, with no time to clean up, and waits until it has ended.
    void kill()
    {
        if (pid_ <= 0)
            return;
        ::kill(pid_, SIGKILL);
        ::waitpid(pid_, nullptr, 0);
        pid_ = -1;
    }

  private:
    pid_t pid_ = -1;
    bool has_it_ = false;
};

} // namespace raymarch::test
