// SPDX-License-Identifier: MIT
#include "protocol/line_reader.hpp"

#include <algorithm>
#include <utility>

namespace raymarch::protocol
{
namespace
{

/// Returns the position of the first CR or LF, or how many bytes were searched when there is none.
/// Searches only as far as the ending of the longest line can be. Without that limit, each line of
/// a chunk whose lines end in CR would search the whole rest of the chunk for an LF.
std::size_t find_ending(std::string_view bytes) noexcept
{
    bytes = bytes.substr(0, max_line_length + 1);
    bytes = bytes.substr(0, bytes.find('\n'));
    return std::min(bytes.find('\r'), bytes.size());
}

} // namespace

std::optional<Line> LineReader::next(std::string_view& bytes) noexcept
{
    while (!bytes.empty()) {
        if (std::exchange(after_cr_, false) && bytes.front() == '\n') {
            bytes.remove_prefix(1);
            continue;
        }
        const std::size_t end = find_ending(bytes);
        const bool ends = end < bytes.size() && (bytes[end] == '\n' || bytes[end] == '\r');
        const std::string_view piece = bytes.substr(0, end);
        after_cr_ = ends && bytes[end] == '\r';
        bytes.remove_prefix(end + (ends ? 1 : 0));
        if (dropping_) {
            dropping_ = !ends;
            continue;
        }
        if (ends && size_ == 0 && piece.size() <= max_line_length)
            return Line{.bytes = piece}; // the whole line is in this chunk, so it is not copied

        const std::size_t taken = std::min(buffer_.size() - size_, piece.size());
        std::copy_n(piece.data(), taken, buffer_.data() + size_);
        size_ += taken;
        const bool too_long = taken < piece.size();
        if (!ends && !too_long)
            continue;
        dropping_ = !ends;
        return Line{.bytes = {buffer_.data(), std::exchange(size_, 0)}, .too_long = too_long};
    }
    return std::nullopt;
}

std::optional<Line> LineReader::finish() noexcept
{
    dropping_ = false;
    after_cr_ = false;
    if (size_ == 0)
        return std::nullopt;
    return Line{.bytes = {buffer_.data(), std::exchange(size_, 0)}};
}

} // namespace raymarch::protocol
