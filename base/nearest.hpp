// SPDX-License-Identifier: MIT
/// @file
/// Guesses which known word a mistyped word was meant to be.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace raymarch
{

/// Returns the edit distance of two words: how many bytes have to be inserted, deleted, changed or
/// swapped with their neighbour to turn one into the other. The case of ASCII letters is ignored.
[[nodiscard]] std::size_t edit_distance(std::string_view one, std::string_view other);

/// Returns the first candidate with the least distance from `word`. The result is empty if that
/// distance is above 2, or above a third of the longer word.
[[nodiscard]] std::optional<std::string_view> nearest(std::string_view word,
                                                      std::span<const std::string_view> candidates);

/// Makes the end of an error message, `; did you mean 'NAME'?`, which is empty if no candidate is
/// near enough.
[[nodiscard]] std::string did_you_mean(std::string_view word,
                                       std::span<const std::string_view> candidates);

} // namespace raymarch
