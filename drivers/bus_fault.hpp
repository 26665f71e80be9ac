// SPDX-License-Identifier: MIT
/// @file
/// Turns SIGBUS inside a watched mapping into zeros and a flag.
///
/// A mapped file that is truncated, or a device that is taken away, answers the next access with
/// SIGBUS. Ending the service would be a crash on bad input; so the handler lays a page of zeros
/// over the hole and the access goes on. A SIGBUS that somebody sends (kill -BUS) changes nothing;
/// a fault at any other place ends the process as ever.
#pragma once

#include <cstddef>

namespace raymarch::drivers
{

inline constexpr std::size_t max_watched_mappings = 8;

/// Starts to watch; installs the handler the first time. False when all places are taken.
[[nodiscard]] bool watch_mapping(void* base, std::size_t length) noexcept;
/// Stops to watch; before the mapping is undone.
void unwatch_mapping(const void* base) noexcept;
/// Whether an access to the mapping at `base` has faulted.
[[nodiscard]] bool mapping_faulted(const void* base) noexcept;

} // namespace raymarch::drivers
