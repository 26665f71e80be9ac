// SPDX-License-Identifier: MIT
/// @file
/// Typed characters to lines, for a person at a terminal program: echo, backspace, Enter as CR.
#pragma once

#include "protocol/line_reader.hpp"

#include <array>
#include <cstddef>
#include <string_view>

namespace raymarch::protocol
{

/// What became of one typed byte.
struct Typed
{
    std::string_view echo; ///< to be sent back; valid until the next call
    bool line_ended = false;
};

/// Edits one line. Longer lines than the protocol's are kept one byte longer, so that the line
/// reader behind finds them too long.
class EchoEditor
{
  public:
    [[nodiscard]] Typed type(char c) noexcept;

    /// The line that has just ended, without its ending; valid until the next type().
    [[nodiscard]] std::string_view line() const noexcept { return {line_.data(), size_}; }

    void reset() noexcept { *this = EchoEditor{}; }

    /// Whether the last byte was a CR: an LF that comes next belongs to it.
    [[nodiscard]] bool after_cr() const noexcept { return after_cr_; }
    void set_after_cr(bool after_cr) noexcept { after_cr_ = after_cr; }

  private:
    std::array<char, max_line_length + 1> line_{};
    std::size_t size_ = 0;
    char echo_ = 0;
    bool ended_ = false;
    bool after_cr_ = false; ///< the LF of CR LF is not a second Enter
};

} // namespace raymarch::protocol
