// SPDX-License-Identifier: MIT
/// @file
/// Shows the progress of long work in one line on standard error.
#pragma once

#include <chrono>
#include <string>
#include <string_view>

namespace raymarch::cli
{

/// Makes a line such as `[####      ] 4/10 frames  40 %  0:12 left` of at most `columns`
/// characters; the bar takes the free space. `unit` is "frames", for example. The time is left out
/// while nothing is done.
[[nodiscard]] std::string progress_line(unsigned done, unsigned total, std::string_view unit,
                                        std::chrono::seconds left, unsigned columns);

/// Prints nothing if standard error is not a terminal. The destructor removes the line.
class Progress
{
  public:
    /// Shows nothing during the time `quiet`.
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
