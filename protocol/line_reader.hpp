// SPDX-License-Identifier: MIT
/// @file
/// Splits chunks of bytes into lines. Any chunking of the same bytes gives the same lines.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string_view>

namespace raymarch::protocol
{

/// The longest line in bytes, without its ending.
inline constexpr std::size_t max_line_length = 1024;

/// One line without its ending. Its views point into the reader or into the bytes given to it, and
/// are valid until the next call.
struct Line
{
    std::string_view bytes;
    bool too_long = false; ///< the line was dropped; `bytes` is its first max_line_length bytes
};

/// Collects bytes until a line is complete. LF, CR, and CR LF each end one. An over-long line is
/// reported once, as soon as it is known to be one, and everything up to its ending is dropped.
class LineReader
{
  public:
    /// Returns the next complete line and removes what it used from the front of `bytes`. The
    /// result is empty if `bytes` ends before the line does.
    [[nodiscard]] std::optional<Line> next(std::string_view& bytes) noexcept;

    /// Returns the unfinished line, if there is one. The end of a file completes a line.
    [[nodiscard]] std::optional<Line> finish() noexcept;

    /// Drops an unfinished line, because the other side hung up.
    void reset() noexcept { *this = LineReader{}; }

    /// Whether the last line ended with a CR. An LF that follows belongs to the same line ending.
    [[nodiscard]] bool after_cr() const noexcept { return after_cr_; }
    void set_after_cr(bool after_cr) noexcept { after_cr_ = after_cr; }

    /// How many bytes of an unfinished line are stored.
    [[nodiscard]] std::size_t pending() const noexcept { return size_; }

  private:
    std::array<char, max_line_length> buffer_{};
    std::size_t size_ = 0;
    bool dropping_ = false;
    bool after_cr_ = false;
};

} // namespace raymarch::protocol
