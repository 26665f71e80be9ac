// SPDX-License-Identifier: MIT
/// @file
/// How far a long piece of work is: one line on standard error, drawn again and again.
#pragma once

#include <chrono>
#include <string>

namespace raymarch::console
{

/// `[####      ]  4/10 frames  40 %  0:12 left`, at most `columns` characters; the bar takes what
/// the rest leaves. The time is left out as long as nothing is done.
[[nodiscard]] std::string progress_line(unsigned done, unsigned total, std::chrono::seconds left,
                                        unsigned columns);

/// Silent where standard error is no terminal. The line is gone when this is.
class Progress
{
  public:
    /// Shows that of `total` frames none is done.
    explicit Progress(unsigned total);
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;
    ~Progress();

    void show(unsigned done);

  private:
    using Clock = std::chrono::steady_clock;

    unsigned total_;
    bool visible_;
    Clock::time_point start_;
    Clock::time_point drawn_{};
};

} // namespace raymarch::console
