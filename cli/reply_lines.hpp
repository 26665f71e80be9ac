// SPDX-License-Identifier: MIT
/// @file
/// Tells for the host which line is a reply, and how many replies are due.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace raymarch::cli
{

/// Returns whether a line is the last line of a reply, `OK` or `ERR`, with or without more words.
[[nodiscard]] bool ends_reply(std::string_view line) noexcept;

/// Returns whether a line belongs to a reply: it is the last line, or begins with `#`.
[[nodiscard]] bool is_reply(std::string_view line) noexcept;

[[nodiscard]] bool is_err(std::string_view reply) noexcept;

/// Returns how many replies are due for these bytes and an LF after them. LF, CR and CR LF end a
/// line. Blank lines and lines that look like replies have no reply.
[[nodiscard]] std::size_t replies_due(std::string_view bytes) noexcept;

/// Appends the checksum mark `*HH` to the line.
[[nodiscard]] std::string with_mark(std::string_view line);

/// Returns whether a line ends in a mark, valid or not; trailing blanks are ignored.
[[nodiscard]] bool has_mark(std::string_view line) noexcept;

/// Returns whether a line ends in a valid mark.
[[nodiscard]] bool has_right_mark(std::string_view line) noexcept;

/// Removes a valid mark at the end of a line.
[[nodiscard]] std::string_view without_mark(std::string_view line) noexcept;

/// Makes bytes readable for a message; a long line is cut.
[[nodiscard]] std::string visible(std::string_view bytes);

} // namespace raymarch::cli
