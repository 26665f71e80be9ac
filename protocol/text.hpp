// SPDX-License-Identifier: MIT
/// @file
/// A part of a line that knows its column, and the few ASCII rules of the protocol.
///
/// The locale is ignored: keys and words are ASCII, whatever the environment says.
#pragma once

#include <cstddef>
#include <string_view>

namespace raymarch::protocol
{

[[nodiscard]] constexpr bool is_blank(char c) noexcept
{
    return c == ' ' || c == '\t';
}
[[nodiscard]] constexpr char to_upper(char c) noexcept
{
    return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
}
[[nodiscard]] constexpr char to_lower(char c) noexcept
{
    return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
}
[[nodiscard]] constexpr bool is_letter(char c) noexcept
{
    return to_upper(c) >= 'A' && to_upper(c) <= 'Z';
}

[[nodiscard]] constexpr bool equal_ignoring_case(std::string_view a, std::string_view b) noexcept
{
    if (a.size() != b.size())
        return false;
    for (std::size_t i = 0; i < a.size(); ++i)
        if (to_upper(a[i]) != to_upper(b[i]))
            return false;
    return true;
}

/// Bytes of a line, and the column of the first byte, counted from 1.
struct Text
{
    std::string_view bytes;
    std::size_t column = 1;

    [[nodiscard]] constexpr bool empty() const noexcept { return bytes.empty(); }

    /// The rest from byte `at` on.
    [[nodiscard]] constexpr Text from(std::size_t at) const noexcept
    {
        return {bytes.substr(at), column + at};
    }
    [[nodiscard]] constexpr Text first(std::size_t count) const noexcept
    {
        return {bytes.substr(0, count), column};
    }
    /// The text without blanks at both ends. Its column is that of the first byte that is not
    /// blank, or that of the end.
    [[nodiscard]] constexpr Text trimmed() const noexcept
    {
        std::size_t begin = 0;
        while (begin < bytes.size() && is_blank(bytes[begin]))
            ++begin;
        std::size_t end = bytes.size();
        while (end > begin && is_blank(bytes[end - 1]))
            --end;
        return from(begin).first(end - begin);
    }
};

/// Takes the part of `rest` before the next `separator`, or all of it. `rest` then begins after the
/// separator, and `found` says whether there was one.
struct Piece
{
    Text text;
    bool found;
};
[[nodiscard]] constexpr Piece take_until(Text& rest, char separator) noexcept
{
    const std::size_t at = rest.bytes.find(separator);
    if (at == std::string_view::npos) {
        const Text all = rest;
        rest = rest.from(rest.bytes.size());
        return {all, false};
    }
    const Text piece = rest.first(at);
    rest = rest.from(at + 1);
    return {piece, true};
}

} // namespace raymarch::protocol
