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
    /// Adds an echo, which is not a reply. Returns false and adds nothing if it does not fit.
    bool push(std::string_view bytes) noexcept;
    /// Adds one whole reply. Returns false and adds nothing if it does not fit.
    bool push_reply(std::string_view reply) noexcept;
    [[nodiscard]] std::string_view pending() const noexcept { return {bytes_.data(), size_}; }
    /// Returns how many bytes fit now.
    [[nodiscard]] std::size_t room() const noexcept { return bytes_.size() - size_; }
    /// Removes the first `count` bytes, which have been sent.
    void pop(std::size_t count) noexcept;
    /// Drops all bytes. Returns how many replies were not completely sent.
    std::size_t clear() noexcept;

  private:
    static constexpr std::size_t shortest_reply = 4; ///< OK, CR, LF

    std::array<char, 16'384> bytes_{};
    std::size_t size_ = 0;
    // A ring buffer with the end of each waiting reply, counted in all bytes that were ever pushed.
    std::array<std::uint32_t, 16'384 / shortest_reply> ends_{};
    std::size_t first_ = 0;
    std::size_t replies_ = 0;
    std::uint32_t sent_ = 0; ///< all bytes that were ever sent or dropped; it wraps
};

} // namespace raymarch::daemon
