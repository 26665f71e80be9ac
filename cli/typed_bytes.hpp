// SPDX-License-Identifier: MIT
/// @file
/// Bytes that are typed, as characters that a line editor keeps, and back: no byte is lost.
///
/// libedit drops what is no character of the locale, and ends a line at NUL. So a byte that is no
/// part of a UTF-8 character stands in the editor as a character of its own in a private area of
/// Unicode, which nobody types, and becomes the byte again when the line is done.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace raymarch::cli
{

struct TypedCharacter
{
    char32_t code = 0;
    std::size_t size = 0; ///< bytes that it took; 0: the character wants more bytes
};

/// The first character of `bytes`, which holds some. `complete`: no more bytes follow soon, so that
/// the beginning of a character stands for itself.
[[nodiscard]] TypedCharacter typed_character(std::string_view bytes, bool complete) noexcept;

/// The bytes that were typed, from the editor's line in UTF-8.
[[nodiscard]] std::string typed_bytes(std::string_view line);

} // namespace raymarch::cli
