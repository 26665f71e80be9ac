// SPDX-License-Identifier: MIT
#include "protocol/line_reader.hpp"

#include <algorithm>

namespace raymarch::protocol
{

Line LineReader::complete(std::string_view bytes) noexcept
{
    size_ = 0;
    if (bytes.ends_with('\r'))
        bytes.remove_suffix(1);
    if (bytes.size() > max_line_length)
        return {.bytes = {}, .too_long = true};
    return {.bytes = bytes};
}

std::optional<Line> LineReader::next(std::string_view& bytes) noexcept
{
    while (!bytes.empty()) {
        const std::size_t end = bytes.find('\n');
        const bool ends = end != std::string_view::npos;
        const std::string_view piece = bytes.substr(0, ends ? end : bytes.size());
        if (dropping_) {
            bytes.remove_prefix(piece.size() + (ends ? 1 : 0));
            dropping_ = !ends;
            continue;
        }
        if (ends && size_ == 0) { // the whole line stands in this chunk: no copy
            bytes.remove_prefix(end + 1);
            return complete(piece);
        }

        const std::size_t room = buffer_.size() - size_;
        const std::size_t taken = std::min(room, piece.size());
        std::copy_n(piece.data(), taken, buffer_.data() + size_);
        size_ += taken;
        // A full buffer is still a line of the greatest length if its last byte is the CR of CR LF.
        const bool overflow =
            taken < piece.size() || (size_ == buffer_.size() && buffer_.back() != '\r');
        if (overflow) {
            bytes.remove_prefix(piece.size() + (ends ? 1 : 0));
            size_ = 0;
            dropping_ = !ends;
            return Line{.bytes = {}, .too_long = true};
        }
        bytes.remove_prefix(taken + (ends ? 1 : 0));
        if (ends)
            return complete({buffer_.data(), size_});
    }
    return std::nullopt;
}

std::optional<Line> LineReader::finish() noexcept
{
    dropping_ = false;
    if (size_ == 0)
        return std::nullopt;
    return complete({buffer_.data(), size_});
}

void LineReader::reset() noexcept
{
    size_ = 0;
    dropping_ = false;
}

} // namespace raymarch::protocol
