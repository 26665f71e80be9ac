// SPDX-License-Identifier: MIT
#include "daemon/config_text.hpp"

#include <algorithm>

namespace raymarch::daemon
{
namespace
{

bool is_control(char c) noexcept
{
    return (static_cast<unsigned char>(c) < ' ' && c != '\t' && c != '\n' && c != '\r') ||
           c == 0x7F;
}

bool is_beyond_ascii(char c) noexcept
{
    return static_cast<unsigned char>(c) > 0x7F;
}

std::string_view from(std::string_view text, std::size_t at) noexcept
{
    return text.substr(std::min(at, text.size()));
}

/// Returns what follows the string at the beginning of `text`. A string without its closing quote
/// ends with its line, or with the text.
std::string_view behind_string(std::string_view text) noexcept
{
    const char quote = text.front();
    const bool is_long = text.size() >= 3 && text[1] == quote && text[2] == quote;
    const std::string_view delimiter = text.substr(0, is_long ? 3 : 1);
    text.remove_prefix(delimiter.size());
    while (!text.empty() && !text.starts_with(delimiter) && (is_long || text.front() != '\n'))
        text = from(text, quote == '"' && text.front() == '\\' ? 2 : 1);
    return from(text, text.starts_with(delimiter) ? delimiter.size() : 0);
}

/// Whether a name follows the bracket. Precondition: `header` begins with the first bracket of its
/// line.
bool has_name(std::string_view header) noexcept
{
    header = from(header, header.starts_with("[[") ? 2 : 1);
    header = from(header, header.find_first_not_of(" \t"));
    return header.find_first_of(
               "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-\"'"
               "]") == 0;
}

} // namespace

std::optional<TextFault> find_text_fault(std::string_view text) noexcept
{
    constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";
    if (text.starts_with(byte_order_mark))
        text.remove_prefix(byte_order_mark.size());
    int line = 1;
    bool line_begins = true;
    while (!text.empty()) {
        const char c = text.front();
        if (is_beyond_ascii(c))
            return TextFault{line, "only strings and comments have characters beyond ASCII"};
        if (c == '[' && line_begins && !has_name(text))
            return TextFault{line, "the header of a table takes a name, as [gpio_lines]"};
        const std::string_view rest = c == '#'                ? from(text, text.find('\n'))
                                      : c == '"' || c == '\'' ? behind_string(text)
                                                              : text.substr(1);
        for (const char taken : text.substr(0, text.size() - rest.size())) {
            if (is_control(taken))
                return TextFault{line, "there is a control character, which no text has"};
            line += taken == '\n' ? 1 : 0;
        }
        line_begins = c == '\n' || (line_begins && (c == ' ' || c == '\t'));
        text = rest;
    }
    return std::nullopt;
}

} // namespace raymarch::daemon
