// SPDX-License-Identifier: MIT
/// @file
/// Finds texts that toml++ (3.3) must not get: for a few texts that are no TOML it fails an
/// assertion or has undefined behaviour instead of reporting an error.
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

/// Finds the first of these faults: a control character; outside of strings and comments a
/// character beyond ASCII; a table's header without a name. TOML allows none of them. A byte order
/// mark may come first.
[[nodiscard]] std::optional<TextFault> find_text_fault(std::string_view text) noexcept;

} // namespace raymarch::daemon
