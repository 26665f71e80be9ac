// SPDX-License-Identifier: MIT
/// @file
/// Reads the GPIO lines of the configuration: where a line is and how it is wired.
#pragma once

#include "base/result.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace raymarch::drivers
{

/// A line is found by its name, or by a chip and an offset.
struct LinePlace
{
    std::string name; ///< empty if the chip is given
    std::string chip; ///< a label, or a path if it begins with '/'
    unsigned offset = 0;
    bool operator==(const LinePlace&) const = default;
};

enum class Pull : std::uint8_t { AsIs, Up, Down, None };

struct LineSpec
{
    std::vector<LinePlace> places; ///< at least one; they are tried in this order
    bool active_low = false;
    Pull pull = Pull::AsIs;
    bool operator==(const LineSpec&) const = default;
};

/// The syntax of parse_line_spec(), for messages.
inline constexpr std::string_view line_spec_syntax =
    "NAME or CHIP:OFFSET, several with | between them, then ,active-low and ,pull-up, ,pull-down "
    "or ,no-pull; a NAME that could be misread needs a ' before and after it";

/// Reads `PLACE[|PLACE…][,active-low][,pull-up|,pull-down|,no-pull]`; a PLACE is `NAME` or
/// `CHIP:OFFSET`. Blanks around names and chips are ignored. Between two `'` every character stands
/// for itself, except that `''` is one `'`: a quoted name may contain a comma or end like an
/// offset. Returns nothing if the syntax is wrong or the text has control characters.
[[nodiscard]] std::optional<LineSpec> parse_line_spec(std::string_view text);

/// Writes the place as the configuration does.
[[nodiscard]] std::string to_string(const LinePlace& place);

} // namespace raymarch::drivers
