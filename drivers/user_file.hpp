// SPDX-License-Identifier: MIT
/// @file
/// Reads and writes what a user names on a command line: a file, a FIFO, a character device such as
/// /dev/null, a descriptor such as /dev/stdout or a shell's <(...), or `-` for the standard stream.
///
/// These functions may wait, so the service uses atomic_file.hpp.
#pragma once

#include "base/result.hpp"

#include <cstdint>
#include <span>
#include <string>

namespace raymarch::drivers
{

/// Writes all bytes. A file is replaced as by replace_file() without durability. It is an error if
/// a FIFO has no reader, or if its reader reads nothing for 30 s. Errors: those of check_output();
/// InputOutput.
[[nodiscard]] Result<void> write_output(const std::string& path,
                                        std::span<const std::uint8_t> bytes);

/// Checks the path before there is anything to write. Errors: Usage for `-` on a terminal;
/// InputOutput for a folder, a socket or a block device.
[[nodiscard]] Result<void> check_output(const std::string& path);

/// Reads to the end. A FIFO without a writer waits 5 s for one. There is no timeout for a writer or
/// a terminal.
/// Errors: Unavailable (the path cannot be opened), InputOutput (it is a folder, a socket, a block
/// device or a FIFO without a writer, or cannot be read), BadData (more than `limit` bytes).
[[nodiscard]] Result<std::string> read_input(const std::string& path, std::size_t limit);

/// Returns the name of the input for messages.
[[nodiscard]] std::string input_name(const std::string& path);

} // namespace raymarch::drivers
