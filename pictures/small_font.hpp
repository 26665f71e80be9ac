// SPDX-License-Identifier: MIT
/// @file
/// ASCII as dots, five wide and seven high, for captions.
#pragma once

#include <cstddef>

namespace raymarch::pictures
{

inline constexpr std::size_t glyph_width = 5;
inline constexpr std::size_t glyph_height = 7;

/// Whether the character has a dot at (x, y), from the top left. What is not printable ASCII is an
/// empty box.
[[nodiscard]] bool has_dot(char character, std::size_t x, std::size_t y) noexcept;

} // namespace raymarch::pictures
