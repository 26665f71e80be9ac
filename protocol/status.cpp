// SPDX-License-Identifier: MIT
#include "protocol/status.hpp"

#include <algorithm>
#include <cassert>
#include <numeric>
#include <utility>

namespace raymarch::protocol
{
namespace
{

/// `rejected.`, which a code follows.
constexpr std::string_view code_prefix = [] {
    const std::string_view name = status_row(StatusKey::RejectedCode).name;
    return name.substr(0, name.find('.') + 1);
}();

/// Whether `word` is one of the words of the row, `up|down|none`. A row without words takes any.
[[maybe_unused]] bool takes_word(const StatusRow& row, std::string_view word)
{
    std::string_view rest = row.value;
    while (!rest.empty()) {
        const std::size_t end = std::min(rest.find('|'), rest.size());
        if (rest.substr(0, end) == word)
            return true;
        rest.remove_prefix(std::min(end + 1, rest.size()));
    }
    return row.value.empty();
}

} // namespace

const StatusRow* find_status_row(std::string_view name) noexcept
{
    if (name.starts_with(code_prefix))
        return &status_row(StatusKey::RejectedCode);
    for (const StatusRow& row : status_rows)
        if (row.name == name)
            return &row;
    return nullptr;
}

void StatusValues::put_text(StatusKey key, [[maybe_unused]] StatusKind kind, std::string text)
{
    std::optional<std::string>& place = texts_[static_cast<std::size_t>(key)];
    assert(!place && status_row(key).kind == kind);
    place = std::move(text);
}

void StatusValues::put(StatusKey key, std::string_view word)
{
    assert(takes_word(status_row(key), word));
    put_text(key, StatusKind::Word, std::string(word));
}

void StatusValues::put(StatusKey key, std::uint64_t number)
{
    put_text(key, StatusKind::Number, std::to_string(number));
}

void StatusValues::put(StatusKey key, Tenths number)
{
    put_text(key, StatusKind::Number,
             std::to_string(number.count / 10) + '.' + std::to_string(number.count % 10));
}

void StatusValues::put_rejected(std::span<const std::uint64_t, error_count> counts)
{
    put(StatusKey::Rejected, std::accumulate(counts.begin(), counts.end(), std::uint64_t{0}));
    std::copy(counts.begin(), counts.end(), rejected_.begin());
}

void StatusValues::write(ReplyWriter& reply) const noexcept
{
    for (const StatusRow& row : status_rows)
        if (const auto& text = texts_[static_cast<std::size_t>(row.key)])
            reply << ' ' << row.name << '=' << *text;
    for (const ErrorRow& row : errors)
        if (const std::uint64_t count = rejected_[static_cast<std::size_t>(row.code)]; count > 0)
            reply << ' ' << code_prefix << row.name << '=' << count;
}

} // namespace raymarch::protocol
