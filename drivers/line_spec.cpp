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

constexpr char quote = '\'';

std::string_view trim(std::string_view text)
{
    const std::size_t first = text.find_first_not_of(' ');
    if (first == std::string_view::npos)
        return {};
    return text.substr(first, text.find_last_not_of(' ') - first + 1);
}

/// Takes the text before the first separator. The separator stays in `rest`.
std::string_view take_until(std::string_view& rest, std::string_view separators)
{
    const std::string_view part = rest.substr(0, rest.find_first_of(separators));
    rest.remove_prefix(part.size());
    return part;
}

/// Takes the text between two quotes. A doubled quote inside is one quote. Returns nothing if the
/// last quote is missing.
std::optional<std::string> take_quoted(std::string_view& rest)
{
    std::string text;
    do {
        rest.remove_prefix(1);
        text += take_until(rest, {&quote, 1});
        if (rest.empty())
            return std::nullopt;
        rest.remove_prefix(1);
        if (rest.starts_with(quote))
            text += quote;
    } while (rest.starts_with(quote));
    return text;
}

std::optional<unsigned> read_offset(std::string_view digits)
{
    unsigned offset = 0;
    const char* const end = digits.data() + digits.size();
    const auto read = std::from_chars(digits.data(), end, offset);
    return read.ec == std::errc{} && read.ptr == end ? std::optional(offset) : std::nullopt;
}

/// A name may contain colons. Only a last colon before a number separates chip and offset.
LinePlace unquoted_place(std::string_view text)
{
    const std::size_t colon = text.rfind(':');
    if (colon != std::string_view::npos)
        if (const auto offset = read_offset(text.substr(colon + 1)))
            return {.name = {}, .chip = std::string(text.substr(0, colon)), .offset = *offset};
    return {.name = std::string(text), .chip = {}};
}

/// Takes the text up to the next place, the first option or the end.
std::optional<LinePlace> take_place(std::string_view& rest)
{
    constexpr std::string_view ends = "|,";
    rest.remove_prefix(std::min(rest.size(), rest.find_first_not_of(' ')));
    LinePlace place;
    if (rest.starts_with(quote)) {
        auto text = take_quoted(rest);
        const std::string_view more = trim(take_until(rest, ends));
        const auto offset = more.starts_with(':') ? read_offset(more.substr(1)) : std::nullopt;
        if (!text || (!more.empty() && !offset))
            return std::nullopt;
        if (offset)
            place = {.name = {}, .chip = std::move(*text), .offset = *offset};
        else
            place.name = std::move(*text);
    } else {
        place = unquoted_place(trim(take_until(rest, ends)));
    }
    return place.name.empty() && place.chip.empty() ? std::nullopt : std::optional(place);
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
    const auto is_control = [](char c) { return static_cast<unsigned char>(c) < ' ' || c == 0x7F; };
    if (std::ranges::any_of(text, is_control))
        return std::nullopt;
    LineSpec spec;
    do {
        if (!spec.places.empty())
            text.remove_prefix(1); // the |
        auto place = take_place(text);
        if (!place)
            return std::nullopt;
        spec.places.push_back(std::move(*place));
    } while (text.starts_with('|'));
    while (text.starts_with(',')) {
        text.remove_prefix(1);
        if (!apply_option(spec, take_until(text, ",")))
            return std::nullopt;
    }
    return spec;
}

std::string to_string(const LinePlace& place)
{
    const bool named = place.chip.empty();
    const std::string& text = named ? place.name : place.chip;
    const bool needs_no_quotes = text.find_first_of("|,") == std::string::npos &&
                                 !text.starts_with(quote) && trim(text) == text && text != "none" &&
                                 (!named || unquoted_place(text) == place);
    std::string written;
    if (needs_no_quotes) {
        written = text;
    } else {
        for (const char c : text)
            written.append(c == quote ? 2 : 1, c);
        written = quote + written + quote;
    }
    return named ? written : written + ':' + std::to_string(place.offset);
}

} // namespace raymarch::drivers
