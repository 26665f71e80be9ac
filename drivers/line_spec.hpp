// SPDX-License-Identifier: MIT
/// @file
/// Which GPIO line is meant and how it is wired, as a configuration writes it.
#pragma once

#include "base/result.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace raymarch::drivers
{

/// Where one line is: its name, or a chip and the position of the line on it.
struct LinePlace
{
    std::string name; ///< of the line; empty where the chip is given
    std::string chip; ///< a label, or a path when it begins with '/'
    unsigned offset = 0;
    bool operator==(const LinePlace&) const = default;
};

enum class Pull : std::uint8_t { AsIs, Up, Down, None };

struct LineSpec
{
    std::vector<LinePlace> places; ///< looked for in this order, at least one
    bool active_low = false;
    Pull pull = Pull::AsIs;
    bool operator==(const LineSpec&) const = default;
};

/// How parse_line_spec() wants it.
inline constexpr std::string_view line_spec_syntax =
    "NAME or CHIP:OFFSET, several with | between them, then ,active-low and ,pull-up, ,pull-down "
    "or ,no-pull; a NAME that could be misread stands between ' and '";

/// `PLACE[|PLACE…][,active-low][,pull-up|,pull-down|,no-pull]`, PLACE being `NAME` or
/// `CHIP:OFFSET`. Names and chips may hold blanks; those around them do not count. Between two `'`
/// any character stands for itself, and `''` for `'`: so a name may hold a comma, or end like an
/// offset. Nothing when the text is not such, or has control characters.
[[nodiscard]] std::optional<LineSpec> parse_line_spec(std::string_view text);

/// The place as a configuration writes it.
[[nodiscard]] std::string to_string(const LinePlace& place);

} // namespace raymarch::drivers
