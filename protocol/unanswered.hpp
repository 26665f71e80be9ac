// SPDX-License-Identifier: MIT
/// @file
/// Tells which lines have no reply: blank ones, and those that look like replies themselves.
///
/// A far end that echoes (a login, a loop-back plug, a terminal in its usual settings) sends every
/// reply back. If the service answered it, both would talk for ever.
#pragma once

#include "protocol/text.hpp"

#include <algorithm>
#include <array>
#include <string_view>

namespace raymarch::protocol
{

/// Every line of a reply begins with one of these. No command and no frame begins with one.
inline constexpr std::array<std::string_view, 3> reply_beginnings = {"OK", "ERR", "#"};

/// Whether a line, without its ending, is a line of a reply. Blanks before it are skipped. Small
/// letters do not match.
[[nodiscard]] constexpr bool looks_like_reply(std::string_view line) noexcept
{
    while (!line.empty() && is_blank(line.front()))
        line.remove_prefix(1);
    return std::ranges::any_of(reply_beginnings, [line](std::string_view beginning) {
        return line.starts_with(beginning);
    });
}

/// Whether the service answers a line, without its ending.
[[nodiscard]] constexpr bool is_answered(std::string_view line) noexcept
{
    return !std::ranges::all_of(line, is_blank) && !looks_like_reply(line);
}

} // namespace raymarch::protocol
