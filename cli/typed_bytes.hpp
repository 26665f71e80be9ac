// SPDX-License-Identifier: MIT
/// @file
/// Converts typed bytes to characters for a line editor, and back. No byte is lost.
///
/// libedit drops bytes that are not a character of the locale, and ends a line at NUL. So such a
/// byte becomes a character in a private use area of Unicode, and becomes the byte again when the
/// line is done.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace raymarch::cli
{

struct TypedCharacter
{
    char32_t code = 0;
    std::size_t size = 0; ///< its number of bytes; 0 if more bytes are needed
};

/// Takes the first character of `bytes`, which is not empty. If `complete`, no more bytes follow,
/// so the first byte of an incomplete character is converted alone.
[[nodiscard]] TypedCharacter typed_character(std::string_view bytes, bool complete) noexcept;

/// Converts the editor's line, which is UTF-8, back to the typed bytes.
[[nodiscard]] std::string typed_bytes(std::string_view line);

} // namespace raymarch::cli
