// SPDX-License-Identifier: MIT
/// @file
/// Completes words in the console.
#pragma once

#include "protocol/accelerators.hpp"

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace raymarch::cli
{

/// Returns the words that may follow `before`, which ends where a word begins.
[[nodiscard]] std::vector<std::string> words_for(const protocol::Accelerator& active,
                                                 std::string_view before);

struct Completion
{
    std::size_t typed = 0;            ///< bytes before the cursor that `text` replaces
    std::string text{};               ///< the common prefix of all words; a single word and a blank
    std::vector<std::string> words{}; ///< all words that begin with the typed text
};

/// Completes the word that ends at the cursor; `before` is the line up to the cursor.
[[nodiscard]] Completion complete(const protocol::Accelerator& active, std::string_view before);

} // namespace raymarch::cli
