// SPDX-License-Identifier: MIT
/// @file
/// Handles SIGBUS inside watched mappings.
///
/// If a mapped file is truncated or a device is removed, the next access raises SIGBUS. So that the
/// service does not crash, the handler maps zeros in place of the mapping and sets a flag. A SIGBUS
/// that somebody sends (kill -BUS) is ignored. A fault at any other address ends the process.
#pragma once

#include <cstddef>

namespace raymarch::drivers
{

inline constexpr std::size_t max_watched_mappings = 8;

/// Watches a mapping. The first call installs the handler. Returns false if the table is full.
[[nodiscard]] bool watch_mapping(void* base, std::size_t length) noexcept;
/// Call this function before munmap().
void unwatch_mapping(const void* base) noexcept;
/// Returns whether an access to the mapping at `base` has faulted.
[[nodiscard]] bool mapping_faulted(const void* base) noexcept;

} // namespace raymarch::drivers
