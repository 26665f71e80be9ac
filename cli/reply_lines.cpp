// SPDX-License-Identifier: MIT
#include "cli/reply_lines.hpp"

#include "protocol/checksum.hpp"
#include "protocol/unanswered.hpp"

#include <fmt/format.h>

namespace raymarch::cli
{
namespace
{

constexpr std::size_t mark_length = 3; // *HH

bool begins_with_word(std::string_view line, std::string_view word) noexcept
{
    if (!line.starts_with(word))
        return false;
    line.remove_prefix(word.size());
    return line.empty() || line.front() == ' ' || line.front() == '*';
}

std::string_view without_trailing_blanks(std::string_view line) noexcept
{
    while (!line.empty() && protocol::is_blank(line.back()))
        line.remove_suffix(1);
    return line;
}

} // namespace

bool is_err(std::string_view reply) noexcept
{
    return begins_with_word(reply, "ERR");
}

bool ends_reply(std::string_view line) noexcept
{
    return begins_with_word(line, "OK") || is_err(line);
}

bool is_reply(std::string_view line) noexcept
{
    return line.starts_with('#') || ends_reply(line);
}

std::size_t replies_due(std::string_view bytes) noexcept
{
    std::size_t due = 0;
    while (!bytes.empty()) {
        // The LF of CR LF ends an empty line here, which has no reply.
        const std::string_view line = bytes.substr(0, bytes.find_first_of("\r\n"));
        due += protocol::is_answered(line) ? 1 : 0;
        bytes.remove_prefix(line.size() < bytes.size() ? line.size() + 1 : line.size());
    }
    return due;
}

std::string with_mark(std::string_view line)
{
    return fmt::format("{}*{:02X}", line, protocol::xor_of(line));
}

bool has_mark(std::string_view line) noexcept
{
    line = without_trailing_blanks(line);
    return line.size() >= mark_length && line[line.size() - mark_length] == '*';
}

bool has_right_mark(std::string_view line) noexcept
{
    if (!has_mark(line))
        return false;
    line = without_trailing_blanks(line);
    const auto high = protocol::hex_value(line[line.size() - 2]);
    const auto low = protocol::hex_value(line[line.size() - 1]);
    line.remove_suffix(mark_length);
    return high && low && (*high << 4 | *low) == protocol::xor_of(line);
}

std::string_view without_mark(std::string_view line) noexcept
{
    if (!has_right_mark(line))
        return line;
    line = without_trailing_blanks(line);
    return line.substr(0, line.size() - mark_length);
}

std::string visible(std::string_view bytes)
{
    constexpr std::size_t longest = 200;
    std::string text;
    for (const char c : bytes.substr(0, longest))
        text += c >= 0x20 && c <= 0x7E ? std::string(1, c)
                                       : fmt::format("\\x{:02X}", static_cast<unsigned char>(c));
    if (bytes.size() > longest)
        text += fmt::format("... ({} bytes)", bytes.size());
    return text;
}

} // namespace raymarch::cli
