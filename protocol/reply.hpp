// SPDX-License-Identifier: MIT
/// @file
/// Outcomes to reply lines: one line each, CR LF, with a checksum where the request had one.
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

/// The longest answer that any request has (HELP) fits in so many bytes; a test proves it.
inline constexpr std::size_t longest_reply = 8192;

/// Writes the reply lines of one request into a buffer of its own; allocates nothing. Text beyond
/// the buffer is cut off, which `overflowed` reports.
class ReplyWriter
{
  public:
    /// Starts a new reply; `checksummed` lines end in `*HH`.
    void begin(bool checksummed) noexcept;

    ReplyWriter& operator<<(std::string_view text) noexcept;
    ReplyWriter& operator<<(char c) noexcept { return *this << std::string_view{&c, 1}; }
    ReplyWriter& operator<<(std::uint64_t number) noexcept;

    /// Eight upper-case hex digits.
    ReplyWriter& hex(std::uint32_t word) noexcept;

    /// Ends the present line.
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

/// `ERR CODE col=N key=K : what is allowed`, ended.
void write_fault(ReplyWriter& reply, const Accelerator& accelerator, const Fault& fault) noexcept;

/// `KEY=VALUE,…` for every parameter, in table order.
void write_state(ReplyWriter& reply, const Accelerator& accelerator, const State& state) noexcept;

/// `KEY=VALUE` of one parameter.
void write_assignment(ReplyWriter& reply, const Accelerator& accelerator, const State& state,
                      std::size_t index) noexcept;

/// ` KEY` for each parameter; of a table within the table its first row and its last key.
void write_keys(ReplyWriter& reply, const Accelerator& accelerator) noexcept;

/// ` WWWWWWWW` for each parameter word.
void write_words(ReplyWriter& reply, const Accelerator& accelerator, const Words& words) noexcept;

/// What a value of this parameter may be: "a number 0 to 10", "sphere, cube, … or 0 to 3".
void write_allowed(ReplyWriter& reply, const Parameter& parameter) noexcept;

} // namespace raymarch::protocol
