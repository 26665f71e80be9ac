// SPDX-License-Identifier: MIT
/// @file
/// The replies that one host has not read yet.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace raymarch::daemon
{

class OutputQueue
{
  public:
    /// Takes bytes that are no reply: an echo. False when they do not fit, and then nothing of them
    /// is taken.
    bool push(std::string_view bytes) noexcept;
    /// Takes one whole reply, of at least four bytes. False as above.
    bool push_reply(std::string_view reply) noexcept;
    [[nodiscard]] std::string_view pending() const noexcept { return {bytes_.data(), size_}; }
    /// How many bytes fit now.
    [[nodiscard]] std::size_t room() const noexcept { return bytes_.size() - size_; }
    /// The first `count` bytes have been sent.
    void pop(std::size_t count) noexcept;
    /// Drops all. Returns how many replies were not sent to their end.
    std::size_t clear() noexcept;

  private:
    static constexpr std::size_t shortest_reply = 4; ///< OK, CR, LF

    std::array<char, 16'384> bytes_{};
    std::size_t size_ = 0;
    // Where each reply that waits ends, counted in all bytes that were ever pushed; a ring.
    std::array<std::uint32_t, 16'384 / shortest_reply> ends_{};
    std::size_t first_ = 0;
    std::size_t replies_ = 0;
    std::uint32_t sent_ = 0; ///< bytes ever sent or dropped; wraps, as the ends do
};

} // namespace raymarch::daemon
