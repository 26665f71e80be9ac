// SPDX-License-Identifier: MIT
/// @file
/// Writes reply lines. Each ends in CR LF, and has a checksum if the request had one.
#pragma once

#include "protocol/errors.hpp"
#include "protocol/parameters.hpp"
#include "protocol/registers.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace raymarch::protocol
{

/// The size of the buffer. The longest answer of any request (HELP) fits; a test proves it.
inline constexpr std::size_t longest_reply = 8192;

/// Writes the reply lines of one request into a buffer inside the object and allocates nothing. If
/// the buffer is full, further text is dropped and `overflowed` is true.
class ReplyWriter
{
  public:
    /// Starts a new reply. If `checksummed` is true, its lines end in `*HH`.
    void begin(bool checksummed) noexcept;

    ReplyWriter& operator<<(std::string_view text) noexcept;
    ReplyWriter& operator<<(char c) noexcept { return *this << std::string_view{&c, 1}; }
    ReplyWriter& operator<<(std::uint64_t number) noexcept;

    /// Writes eight upper-case hex digits.
    ReplyWriter& hex(std::uint32_t word) noexcept;

    /// Ends the current line.
    void end_line() noexcept;

    [[nodiscard]] std::string_view text() const noexcept { return {buffer_.data(), size_}; }
    [[nodiscard]] bool overflowed() const noexcept { return overflowed_; }

  private:
    std::array<char, longest_reply> buffer_{};
    std::size_t size_ = 0;
    std::size_t line_begin_ = 0;
    bool checksummed_ = false;
    bool overflowed_ = false;
};

/// Writes the line `ERR CODE col=N key=K : what is allowed` and ends it.
void write_fault(ReplyWriter& reply, const Accelerator& accelerator, const Fault& fault) noexcept;

/// Writes `KEY=VALUE,…` for every parameter, in table order.
void write_state(ReplyWriter& reply, const Accelerator& accelerator, const State& state) noexcept;

/// Writes `KEY=VALUE` for one parameter.
void write_assignment(ReplyWriter& reply, const Accelerator& accelerator, const State& state,
                      std::size_t index) noexcept;

/// Writes ` KEY` for each parameter. For a table within the table it writes only the first row and
/// the last key.
void write_keys(ReplyWriter& reply, const Accelerator& accelerator) noexcept;

/// Writes ` WWWWWWWW` for each parameter word.
void write_words(ReplyWriter& reply, const Accelerator& accelerator, const Words& words) noexcept;

/// Writes which values a parameter may have: "a number 0 to 10", "sphere, cube, … or 0 to 3".
void write_allowed(ReplyWriter& reply, const Parameter& parameter) noexcept;

} // namespace raymarch::protocol
