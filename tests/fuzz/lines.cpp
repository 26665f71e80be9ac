// SPDX-License-Identifier: MIT
/// @file
/// Any chunking of the same bytes gives the same lines.
#include "protocol/line_reader.hpp"

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <utility>
#include <vector>

namespace
{

using Lines = std::vector<std::pair<std::string, bool>>;

/// Feeds `bytes` in pieces of 1 to `largest` bytes.
Lines lines_of(std::string_view bytes, std::size_t largest)
{
    raymarch::protocol::LineReader reader;
    Lines lines;
    std::size_t size = 1;
    while (!bytes.empty()) {
        std::string_view chunk = bytes.substr(0, size);
        bytes.remove_prefix(chunk.size());
        size = size % largest + 1;
        while (const auto line = reader.next(chunk))
            lines.emplace_back(line->bytes, line->too_long);
    }
    if (const auto line = reader.finish())
        lines.emplace_back(line->bytes, line->too_long);
    return lines;
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    const std::string_view bytes(reinterpret_cast<const char*>(data), size);
    const Lines whole = lines_of(bytes, size + 1);
    if (lines_of(bytes, 1) != whole || lines_of(bytes, 7) != whole)
        std::abort();
    return 0;
}
