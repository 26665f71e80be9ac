// SPDX-License-Identifier: MIT
/// @file
/// The known word that a mistyped one was meant to be.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace raymarch
{

/// How many bytes have to be put in, left out, changed or exchanged with their neighbour to make
/// one word of the other. ASCII letters count as equal in both cases.
[[nodiscard]] std::size_t edit_distance(std::string_view one, std::string_view other);

/// The candidate with the least distance from `word`, the first of several; nothing where each is
/// further away than 2, or than a third of the longer word.
[[nodiscard]] std::optional<std::string_view> nearest(std::string_view word,
                                                      std::span<const std::string_view> candidates);

/// `; did you mean 'NAME'?` of the nearest candidate, to stand behind an error; else empty.
[[nodiscard]] std::string did_you_mean(std::string_view word,
                                       std::span<const std::string_view> candidates);

} // namespace raymarch
