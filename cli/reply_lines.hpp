// SPDX-License-Identifier: MIT
/// @file
/// The host's view of lines and replies: which line is a reply, and how many are due.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace raymarch::cli
{

/// Whether this line ends a reply: `OK` or `ERR CODE`, with or without more words or a mark.
[[nodiscard]] bool ends_reply(std::string_view line) noexcept;

/// Whether this line belongs to a reply: one that ends it, or one that begins with `#`.
[[nodiscard]] bool is_reply(std::string_view line) noexcept;

/// Whether a reply is an ERR.
[[nodiscard]] bool is_err(std::string_view reply) noexcept;

/// How many replies are due for these bytes and the LF that will follow them. LF, CR and CR LF end
/// a line; blank lines and lines that look like replies are not answered.
[[nodiscard]] std::size_t replies_due(std::string_view bytes) noexcept;

/// The line with its checksum mark, `*HH`, behind it.
[[nodiscard]] std::string with_mark(std::string_view line);

/// Whether a line ends in a mark, right or wrong; blanks behind it do not count.
[[nodiscard]] bool has_mark(std::string_view line) noexcept;

/// Whether a line ends in a mark that fits it.
[[nodiscard]] bool has_right_mark(std::string_view line) noexcept;

/// The line without the mark at its end, where there is one that fits.
[[nodiscard]] std::string_view without_mark(std::string_view line) noexcept;

/// Bytes as a person can read them in one line; a long line is cut.
[[nodiscard]] std::string visible(std::string_view bytes);

} // namespace raymarch::cli
