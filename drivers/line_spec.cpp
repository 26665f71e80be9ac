// SPDX-License-Identifier: MIT
#include "drivers/line_spec.hpp"

#include <algorithm>
#include <array>
#include <charconv>

namespace raymarch::drivers
{
namespace
{

struct PullName
{
    std::string_view name;
    Pull pull;
};
constexpr std::array pull_names = {
    PullName{"pull-up", Pull::Up},
    PullName{"pull-down", Pull::Down},
    PullName{"no-pull", Pull::None},
};

/// The text before the first `separator`; `rest` is what follows it, or has no data at the end.
std::string_view take_part(std::string_view& rest, char separator)
{
    const std::size_t end = rest.find(separator);
    const std::string_view part = rest.substr(0, end);
    rest = end == std::string_view::npos ? std::string_view() : rest.substr(end + 1);
    return part;
}

/// A name may hold colons: only one with a number behind it parts chip and offset.
std::optional<LinePlace> parse_place(std::string_view text)
{
    if (text.empty())
        return std::nullopt;
    const std::size_t colon = text.rfind(':');
    if (colon == std::string_view::npos)
        return LinePlace{.name = std::string(text), .chip = {}};
    LinePlace place;
    const std::string_view digits = text.substr(colon + 1);
    const char* const end = digits.data() + digits.size();
    const auto read = std::from_chars(digits.data(), end, place.offset);
    if (read.ec != std::errc{} || read.ptr != end)
        return LinePlace{.name = std::string(text), .chip = {}};
    if (colon == 0)
        return std::nullopt;
    place.chip = text.substr(0, colon);
    return place;
}

bool apply_option(LineSpec& spec, std::string_view option)
{
    if (option == "active-low" && !spec.active_low) {
        spec.active_low = true;
        return true;
    }
    const auto* const row = std::ranges::find(pull_names, option, &PullName::name);
    if (row == pull_names.end() || spec.pull != Pull::AsIs)
        return false;
    spec.pull = row->pull;
    return true;
}

} // namespace

std::optional<LineSpec> parse_line_spec(std::string_view text)
{
    if (text.ends_with(',') || text.find_first_of(" \t\n") != std::string_view::npos)
        return std::nullopt;
    LineSpec spec;
    std::string_view places = take_part(text, ',');
    if (places.ends_with('|'))
        return std::nullopt;
    do {
        auto place = parse_place(take_part(places, '|'));
        if (!place)
            return std::nullopt;
        spec.places.push_back(std::move(*place));
    } while (!places.empty());
    while (!text.empty())
        if (!apply_option(spec, take_part(text, ',')))
            return std::nullopt;
    return spec;
}

std::string to_string(const LinePlace& place)
{
    return place.chip.empty() ? place.name : place.chip + ':' + std::to_string(place.offset);
}

} // namespace raymarch::drivers
