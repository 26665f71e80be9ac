// SPDX-License-Identifier: MIT
/// @file
/// Reads and replaces whole files. A file is replaced by an atomic rename, so a reader sees the old
/// or the new one. Only ordinary files are accepted, so nothing here waits for another process.
#pragma once

#include "base/result.hpp"
#include "base/temporary_file.hpp"

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace raymarch::drivers
{

using raymarch::Durability;

/// Replaces the file by way of a TemporaryFile, which tells what the new file keeps of the old one.
/// Errors: InputOutput.
[[nodiscard]] Result<void> replace_file(const std::string& path,
                                        std::span<const std::uint8_t> bytes, Durability durability);

/// Returns the whole content. Errors: Unavailable (the file cannot be opened; `number` is ENOENT if
/// it does not exist), InputOutput (it is not an ordinary file, or cannot be read), BadData (it is
/// larger than `limit` bytes).
[[nodiscard]] Result<std::string> read_file(const std::string& path, std::size_t limit);

/// Renames a file that cannot be used to the first free name of `path`.bad, `path`.bad-2 and so on.
/// If `path` is a symbolic link, the file that it leads to is renamed. Returns the new name.
/// Errors: Unavailable (there is no file), InputOutput (it is not an ordinary file, the rename
/// failed, or no name is free).
[[nodiscard]] Result<std::string> set_aside(const std::string& path);

[[nodiscard]] inline std::span<const std::uint8_t> as_bytes(std::string_view text) noexcept
{
    return {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()};
}

} // namespace raymarch::drivers
