// SPDX-License-Identifier: MIT
/// @file
/// What TAB offers at a place of a line.
#pragma once

#include "protocol/accelerators.hpp"

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace raymarch::cli
{

/// What may stand behind `before`, which ends where a word begins.
[[nodiscard]] std::vector<std::string> words_for(const protocol::Accelerator& active,
                                                 std::string_view before);

struct Completion
{
    std::size_t typed = 0; ///< bytes before the cursor that `text` replaces
    std::string text{};    ///< what all the words begin with; of a single word all and a blank
    std::vector<std::string> words{}; ///< that begin with what was typed; none: nothing fits
};

/// Completes the word that ends at the cursor; `before` is the line up to there.
[[nodiscard]] Completion complete(const protocol::Accelerator& active, std::string_view before);

} // namespace raymarch::cli
