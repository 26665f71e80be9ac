// SPDX-License-Identifier: MIT
/// @file
/// Whole files: read at once, or replaced so that a reader sees the old or the new one, never a
/// part. Only ordinary files are read and replaced, so that nothing here waits for another process.
#pragma once

#include "base/result.hpp"
#include "base/unfinished_file.hpp"

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace raymarch::drivers
{

using raymarch::Durability;

/// Writes beside the file and renames over it; UnfinishedFile says what is kept of the old one.
/// Errors: InputOutput; the old content stays.
[[nodiscard]] Result<void> replace_file(const std::string& path,
                                        std::span<const std::uint8_t> bytes, Durability durability);

/// The whole content. Errors: Unavailable (cannot be opened; `number` is ENOENT where there is no
/// such file), InputOutput (not an ordinary file, or it cannot be read); BadData when it is larger
/// than `limit` bytes.
[[nodiscard]] Result<std::string> read_file(const std::string& path, std::size_t limit);

/// Moves a file that is of no use out of the way, without writing over anything: to `path`.bad,
/// `path`.bad-2 and so on; a link is followed, and stays. Returns the new name.
/// Errors: Unavailable (there is no file), InputOutput (not an ordinary file, the folder takes no
/// new name, no name is free).
[[nodiscard]] Result<std::string> set_aside(const std::string& path);

[[nodiscard]] inline std::span<const std::uint8_t> as_bytes(std::string_view text) noexcept
{
    return {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()};
}

} // namespace raymarch::drivers
