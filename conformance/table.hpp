// SPDX-License-Identifier: MIT
/// @file
/// Table files: what is sent to the service, and what it has to answer.
///
/// A row has four columns, separated by tabs: send, expect, words, why. Empty lines and lines that
/// begin with `#` are left out. The rows of a file run in order and start from the defaults.
///
/// - send: `\r \n \t \\ \xHH` are bytes, `\(N*TEXT)` is TEXT repeated N times. LF is added unless
/// the
///   column has a `\n`.
/// - expect: one pattern for each reply, joined by ` | `; `-` for no reply. See match().
/// - words: the parameter words after the row in hex, `=` for those before it, `-` not looked at.
#pragma once

#include "base/result.hpp"

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace raymarch::conformance
{

/// What is known of the parameter words after a row.
enum class WordsCheck : std::uint8_t {
    Unchecked,
    Same,  ///< as before the row
    Exact, ///< `Row::words`
};

struct Row
{
    std::size_t line = 0;             ///< in the file, from 1
    std::string send;                 ///< the bytes, with their line endings
    std::vector<std::string> replies; ///< patterns, in order; none when nothing is answered
    WordsCheck words_check = WordsCheck::Unchecked;
    std::vector<std::uint32_t> words; ///< for Exact
    std::string why;
};

/// Reads a whole file's text. Errors: BadData, "line N: what is wrong".
[[nodiscard]] Result<std::vector<Row>> parse_table(std::string_view text);

/// Whether `reply`, without its line ending, is what `pattern` describes. The sentence of a reply,
/// from ` : ` on, is not compared. `#` matches one or more digits, `...` at the end any rest, `*??`
/// at the end a checksum that is right for the whole reply, sentence included.
[[nodiscard]] bool match(std::string_view pattern, std::string_view reply);

} // namespace raymarch::conformance
