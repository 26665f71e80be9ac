// SPDX-License-Identifier: MIT
/// @file
/// Whole files: read at once, or replaced so that a reader sees the old or the new one, never a
/// part.
#pragma once

#include "base/result.hpp"

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace raymarch::drivers
{

/// Whether the new content must survive a power cut (fsync of file and folder) or may be lost.
enum class Durability : std::uint8_t { Durable, BestEffort };

/// Writes `path`.new and renames it over. Errors: InputOutput; the old content stays.
[[nodiscard]] Result<void> replace_file(const std::string& path,
                                        std::span<const std::uint8_t> bytes, Durability durability);

/// The whole content. Errors: Unavailable (cannot be opened), InputOutput; BadData when the file is
/// larger than `limit` bytes.
[[nodiscard]] Result<std::string> read_file(const std::string& path, std::size_t limit);

[[nodiscard]] inline std::span<const std::uint8_t> as_bytes(std::string_view text) noexcept
{
    return {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()};
}

} // namespace raymarch::drivers
