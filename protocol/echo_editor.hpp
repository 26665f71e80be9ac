// SPDX-License-Identifier: MIT
/// @file
/// Turns typed characters into lines, for a person at a terminal program. It makes the echo, and
/// handles backspace and Enter, which is a CR.
#pragma once

#include "protocol/line_reader.hpp"

#include <array>
#include <cstddef>
#include <string_view>

namespace raymarch::protocol
{

/// The result of one typed byte.
struct Typed
{
    std::string_view echo; ///< the bytes to send back; valid until the next call
    bool line_ended = false;
};

/// Edits one line. A line that is too long for the protocol is kept with one byte too many, so that
/// the line reader reports it.
class EchoEditor
{
  public:
    [[nodiscard]] Typed type(char c) noexcept;

    /// The line that has just ended, without its ending; valid until the next type().
    [[nodiscard]] std::string_view line() const noexcept { return {line_.data(), size_}; }

    void reset() noexcept { *this = EchoEditor{}; }

    /// Whether the last byte was a CR. An LF that follows belongs to the same line ending.
    [[nodiscard]] bool after_cr() const noexcept { return after_cr_; }
    void set_after_cr(bool after_cr) noexcept { after_cr_ = after_cr; }

  private:
    std::array<char, max_line_length + 1> line_{};
    std::size_t size_ = 0;
    char echo_ = 0;
    bool ended_ = false;
    bool after_cr_ = false; ///< if true, an LF is not a second Enter
};

} // namespace raymarch::protocol
