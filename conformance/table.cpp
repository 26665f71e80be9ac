// SPDX-License-Identifier: MIT
#include "conformance/table.hpp"

#include "protocol/checksum.hpp"

#include <array>
#include <charconv>
#include <optional>

namespace raymarch::conformance
{
namespace
{

constexpr std::size_t most_repeats = 1'000'000;
constexpr std::string_view any_checksum = "*??";
constexpr std::string_view any_rest = "...";
constexpr std::string_view sentence = " : ";

/// The parts of `text` between separators; one more than there are separators.
std::vector<std::string_view> split(std::string_view text, std::string_view separator)
{
    std::vector<std::string_view> parts;
    for (;;) {
        const std::size_t at = text.find(separator);
        parts.push_back(text.substr(0, at));
        if (at == std::string_view::npos)
            return parts;
        text.remove_prefix(at + separator.size());
    }
}

template <typename Number>
std::optional<Number> whole_number(std::string_view text, int base)
{
    Number value{};
    const char* const end = text.data() + text.size();
    const auto [stop, error] = std::from_chars(text.data(), end, value, base);
    if (error != std::errc{} || stop != end)
        return std::nullopt;
    return value;
}

/// The byte of a one-letter escape.
std::optional<char> letter_escape(char letter)
{
    switch (letter) {
    case 'r':
        return '\r';
    case 'n':
        return '\n';
    case 't':
        return '\t';
    case '\\':
        return '\\';
    default:
        return std::nullopt;
    }
}

/// `N*TEXT)` at the front of `rest`, appended to `bytes`.
bool take_repeated(std::string_view& rest, std::string& bytes)
{
    const std::size_t star = rest.find('*');
    const std::size_t end = rest.find(')', star);
    if (star == std::string_view::npos || end == std::string_view::npos)
        return false;
    const auto count = whole_number<std::size_t>(rest.substr(0, star), 10);
    if (!count || *count > most_repeats)
        return false;
    for (std::size_t i = 0; i < *count; ++i)
        bytes += rest.substr(star + 1, end - star - 1);
    rest.remove_prefix(end + 1);
    return true;
}

/// What follows a backslash, appended to `bytes`.
bool take_escape(std::string_view& rest, std::string& bytes)
{
    if (rest.empty())
        return false;
    const char kind = rest.front();
    rest.remove_prefix(1);
    if (kind == '(')
        return take_repeated(rest, bytes);
    if (kind == 'x') {
        const auto code = whole_number<std::uint8_t>(rest.substr(0, 2), 16);
        if (!code || rest.size() < 2)
            return false;
        bytes += static_cast<char>(*code);
        rest.remove_prefix(2);
        return true;
    }
    const auto byte = letter_escape(kind);
    if (byte)
        bytes += *byte;
    return byte.has_value();
}

std::optional<std::string> unescape(std::string_view column)
{
    std::string bytes;
    while (!column.empty()) {
        const char c = column.front();
        column.remove_prefix(1);
        if (c != '\\')
            bytes += c;
        else if (!take_escape(column, bytes))
            return std::nullopt;
    }
    if (bytes.find('\n') == std::string::npos)
        bytes += '\n';
    return bytes;
}

bool read_words(std::string_view column, Row& row)
{
    if (column == "-" || column == "=") {
        row.words_check = column == "=" ? WordsCheck::Same : WordsCheck::Unchecked;
        return true;
    }
    row.words_check = WordsCheck::Exact;
    for (const std::string_view text : split(column, " ")) {
        const auto word = whole_number<std::uint32_t>(text, 16);
        if (!word || text.size() != 8)
            return false;
        row.words.push_back(*word);
    }
    return true;
}

Result<Row> parse_row(std::string_view line)
{
    const auto wrong = [](const char* what) { return fail(plain_error(ErrorKind::BadData, what)); };
    const auto columns = split(line, "\t");
    if (columns.size() != 4)
        return wrong("a row has four columns: send, expect, words, why");
    for (const std::string_view column : columns)
        if (column.empty())
            return wrong("a column is empty");

    Row row;
    auto send = unescape(columns[0]);
    if (!send)
        return wrong("an escape is none of \\r \\n \\t \\\\ \\xHH \\(N*TEXT)");
    row.send = std::move(*send);
    if (columns[1] != "-")
        for (const std::string_view pattern : split(columns[1], " | "))
            row.replies.emplace_back(pattern);
    if (!read_words(columns[2], row))
        return wrong("the words are '=', '-' or words of eight hex digits");
    row.why = columns[3];
    return row;
}

bool is_digit(char c) noexcept
{
    return c >= '0' && c <= '9';
}

/// `text` begins as `pattern` says; returns what follows.
std::optional<std::string_view> match_front(std::string_view pattern, std::string_view text)
{
    for (const char c : pattern) {
        if (text.empty() || (c == '#' ? !is_digit(text.front()) : c != text.front()))
            return std::nullopt;
        text.remove_prefix(1);
        while (c == '#' && !text.empty() && is_digit(text.front()))
            text.remove_prefix(1);
    }
    return text;
}

/// Takes a checksum that is right for the text before it off the end.
bool take_checksum(std::string_view& reply)
{
    if (reply.size() < any_checksum.size())
        return false;
    const std::string_view before = reply.substr(0, reply.size() - any_checksum.size());
    const std::uint8_t sum = protocol::xor_of(before);
    const std::array<char, 3> mark = {'*', protocol::hex_digits[sum >> 4],
                                      protocol::hex_digits[sum & 0xF]};
    if (!reply.ends_with(std::string_view(mark.data(), mark.size())))
        return false;
    reply = before;
    return true;
}

} // namespace

Result<std::vector<Row>> parse_table(std::string_view text)
{
    std::vector<Row> rows;
    std::size_t number = 0;
    for (const std::string_view line : split(text, "\n")) {
        ++number;
        if (line.empty() || line.starts_with('#'))
            continue;
        auto row = parse_row(line);
        if (!row)
            return fail(plain_error(ErrorKind::BadData,
                                    "line " + std::to_string(number) + ": " + row.error().message));
        row->line = number;
        rows.push_back(std::move(*row));
    }
    return rows;
}

bool match(std::string_view pattern, std::string_view reply)
{
    if (pattern.ends_with(any_checksum)) {
        pattern.remove_suffix(any_checksum.size());
        if (!take_checksum(reply))
            return false;
    }
    reply = reply.substr(0, reply.find(sentence));
    const bool open = pattern.ends_with(any_rest);
    if (open)
        pattern.remove_suffix(any_rest.size());
    const auto rest = match_front(pattern, reply);
    return rest && (open || rest->empty());
}

} // namespace raymarch::conformance
