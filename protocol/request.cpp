// SPDX-License-Identifier: MIT
#include "protocol/request.hpp"

#include "protocol/checksum.hpp"
#include "protocol/unanswered.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>

namespace raymarch::protocol
{
namespace
{

constexpr std::size_t mark_length = 3; // *HH

bool is_allowed(char c) noexcept
{
    return (c >= 0x20 && c <= 0x7E) || c == '\t';
}

/// Sixteen bytes at a time: whether some byte is below 0x20 or above 0x7E. A TAB counts too, so
/// that a line with one is looked at byte by byte.
bool may_hold_bad_byte(std::string_view bytes) noexcept
{
    // As signed numbers, bytes from 0x80 on are below 0x20 too.
    using Block = signed char __attribute__((vector_size(16)));
    Block found = {};
    Block block = {};
    for (; bytes.size() >= sizeof block; bytes.remove_prefix(sizeof block)) {
        std::memcpy(&block, bytes.data(), sizeof block);
        found |= (block < 0x20) | (block == 0x7F);
    }
    std::array<std::uint64_t, 2> halves{};
    std::memcpy(halves.data(), &found, sizeof found);
    return (halves[0] | halves[1]) != 0 || !std::ranges::all_of(bytes, is_allowed);
}

/// The first byte that no line may hold, or the line's size.
std::size_t find_bad_byte(std::string_view bytes) noexcept
{
    if (!may_hold_bad_byte(bytes))
        return bytes.size();
    const auto* const bad = std::ranges::find_if_not(bytes, is_allowed);
    return static_cast<std::size_t>(bad - bytes.begin());
}

std::string_view without_trailing_blanks(std::string_view bytes) noexcept
{
    while (!bytes.empty() && is_blank(bytes.back()))
        bytes.remove_suffix(1);
    return bytes;
}

/// The value of the two hex digits of a mark.
std::optional<std::uint8_t> mark_value(std::string_view mark) noexcept
{
    const auto high = hex_value(mark[1]);
    const auto low = hex_value(mark[2]);
    if (!high || !low)
        return std::nullopt;
    return static_cast<std::uint8_t>(*high << 4 | *low);
}

Request faulty(Request request, Fault fault) noexcept
{
    request.kind = Request::Kind::Faulty;
    request.fault = fault;
    return request;
}

/// Cuts the mark off `request.text`, or says what is wrong with it.
std::optional<Fault> check_mark(Request& request, bool require_checksum) noexcept
{
    const std::string_view bytes = without_trailing_blanks(request.text.bytes);
    if (bytes.size() < mark_length || bytes[bytes.size() - mark_length] != '*') {
        if (require_checksum)
            return Fault{.code = ErrorCode::Checksum};
        return std::nullopt;
    }
    request.checksummed = true;
    const std::size_t before = bytes.size() - mark_length;
    if (mark_value(bytes.substr(before)) != xor_of(bytes.substr(0, before)))
        return Fault{.code = ErrorCode::Checksum, .column = request.text.column + before + 1};
    request.text = request.text.first(before);
    return std::nullopt;
}

} // namespace

Request read_request(const Line& line, bool require_checksum) noexcept
{
    Request request{.text = {.bytes = line.bytes}};
    if (looks_like_reply(line.bytes)) {
        request.kind = Request::Kind::Reply;
        return request;
    }
    if (line.too_long)
        return faulty(request, {.code = ErrorCode::TooLong});
    if (request.text.trimmed().empty())
        return request;
    const std::size_t bad = find_bad_byte(line.bytes);
    if (bad < line.bytes.size())
        return faulty(request, {.code = ErrorCode::BadByte, .column = bad + 1});
    if (auto fault = check_mark(request, require_checksum))
        return faulty(request, *fault);

    request.text.bytes = without_trailing_blanks(request.text.bytes);
    request.text = request.text.trimmed();
    const std::string_view bytes = request.text.bytes;
    const auto* const separator =
        std::ranges::find_if(bytes, [](char c) { return is_blank(c) || c == ',' || c == '='; });
    const auto word_end = static_cast<std::size_t>(separator - bytes.begin());
    const Text behind = request.text.from(word_end).trimmed();
    if (word_end == 0 || behind.bytes.starts_with('=')) {
        request.kind = Request::Kind::Frame;
        return request;
    }

    const std::string_view word = bytes.substr(0, word_end);
    request.command = find_command(word);
    if (request.command == nullptr)
        return faulty(
            request,
            {.code = ErrorCode::UnknownCommand, .column = request.text.column, .word = word});
    request.command_column = request.text.column;
    request.text = behind;
    request.kind = Request::Kind::Command;
    return request;
}

} // namespace raymarch::protocol
