// SPDX-License-Identifier: MIT
/// @file
/// What a person names on a command line to be written or read: a file, but also a FIFO, a
/// character device such as /dev/null, a descriptor such as /dev/stdout or a shell's <(...), or `-`
/// for the standard stream.
///
/// This is for the tool, which may wait. The service uses atomic_file.hpp.
#pragma once

#include "base/result.hpp"

#include <cstdint>
#include <span>
#include <string>

namespace raymarch::drivers
{

/// Writes all of it: into a FIFO, a device or a descriptor; a file is replaced as by replace_file()
/// without durability. A FIFO without a reader is not waited for, and a reader that takes nothing
/// for 30 s is given up.
/// Errors: those of check_output(); InputOutput.
[[nodiscard]] Result<void> write_output(const std::string& path,
                                        std::span<const std::uint8_t> bytes);

/// What can be said of write_output() before there is anything to write. Errors: Usage for `-` on a
/// terminal; InputOutput for a folder, a socket, a block device.
[[nodiscard]] Result<void> check_output(const std::string& path);

/// Reads to the end. A FIFO waits 5 s for somebody who writes to it; whoever writes, or a terminal,
/// is waited for as long as it takes.
/// Errors: Unavailable (cannot be opened), InputOutput (a folder, a socket, a block device, a FIFO
/// that nobody writes to; it cannot be read), BadData when there are more than `limit` bytes.
[[nodiscard]] Result<std::string> read_input(const std::string& path, std::size_t limit);

/// How messages name what read_input() reads.
[[nodiscard]] std::string input_name(const std::string& path);

} // namespace raymarch::drivers
