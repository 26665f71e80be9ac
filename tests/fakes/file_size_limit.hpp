// SPDX-License-Identifier: MIT
/// @file
/// A disk that is full, for a test: files cannot grow beyond a limit while this lives.
#pragma once

#include <sys/resource.h>

#include <csignal>

namespace raymarch::test
{

class FileSizeLimit
{
  public:
    explicit FileSizeLimit(rlim_t bytes)
    {
        ::getrlimit(RLIMIT_FSIZE, &old_);
        const rlimit limit{bytes, old_.rlim_max};
        ::setrlimit(RLIMIT_FSIZE, &limit);
    }
    FileSizeLimit(const FileSizeLimit&) = delete;
    FileSizeLimit& operator=(const FileSizeLimit&) = delete;
    ~FileSizeLimit()
    {
        ::setrlimit(RLIMIT_FSIZE, &old_);
        static_cast<void>(std::signal(SIGXFSZ, handler_));
    }

  private:
    using Handler = void (*)(int);
    Handler handler_ = std::signal(SIGXFSZ, SIG_IGN); ///< or the write would end the test
    rlimit old_{};
};

} // namespace raymarch::test
