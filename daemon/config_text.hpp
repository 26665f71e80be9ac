// SPDX-License-Identifier: MIT
/// @file
/// What toml++ (3.3) has to be kept from: over a few texts that are no TOML it does not report an
/// error, but fails an assertion or leaves what C++ defines, and so may end the program.
#pragma once

#include <optional>
#include <string_view>

namespace raymarch::daemon
{

struct TextFault
{
    int line; ///< from 1
    std::string_view what;
};

/// The first of: a control character; outside of strings and comments a character beyond ASCII; a
/// table's header without a name. TOML allows none of them. A mark of the byte order may come
/// first.
[[nodiscard]] std::optional<TextFault> find_text_fault(std::string_view text) noexcept;

} // namespace raymarch::daemon
