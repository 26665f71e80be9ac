// SPDX-License-Identifier: MIT
/// @file
/// How far a long piece of work is: one line on standard error, drawn again and again.
#pragma once

#include <chrono>
#include <string>
#include <string_view>

namespace raymarch::cli
{

/// `[####      ]  4/10 frames  40 %  0:12 left`, at most `columns` characters; the bar takes what
/// the rest leaves. `unit` is what is counted. The time is left out as long as nothing is done.
[[nodiscard]] std::string progress_line(unsigned done, unsigned total, std::string_view unit,
                                        std::chrono::seconds left, unsigned columns);

/// Silent where standard error is no terminal. The line is gone when this is.
class Progress
{
  public:
    /// Shows that of `total` things, such as frames, none is done. What takes less time than
    /// `quiet` is not shown at all.
    Progress(unsigned total, std::string_view unit, std::chrono::milliseconds quiet = {});
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;
    ~Progress();

    void show(unsigned done);

  private:
    using Clock = std::chrono::steady_clock;

    unsigned total_;
    std::string_view unit_;
    std::chrono::milliseconds quiet_;
    bool visible_;
    bool drawn_once_ = false;
    Clock::time_point start_;
    Clock::time_point drawn_{};
};

} // namespace raymarch::cli
