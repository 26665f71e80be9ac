// SPDX-License-Identifier: MIT
/// @file
/// The replies that one host has not read yet.
#pragma once

#include <array>
#include <cstddef>
#include <string_view>

namespace raymarch::daemon
{

class OutputQueue
{
  public:
    /// False when it does not fit, and then nothing of it is taken.
    bool push(std::string_view bytes) noexcept;
    [[nodiscard]] std::string_view pending() const noexcept { return {bytes_.data(), size_}; }
    /// How many bytes fit now.
    [[nodiscard]] std::size_t room() const noexcept { return bytes_.size() - size_; }
    /// The first `count` bytes have been sent.
    void pop(std::size_t count) noexcept;
    /// Drops all. Returns how many replies were not sent to their end.
    std::size_t clear() noexcept;

  private:
    std::array<char, 16'384> bytes_{};
    std::size_t size_ = 0;
    char cut_line_ = 0; ///< the first byte of the line that is sent in part; 0: none is
};

} // namespace raymarch::daemon
