// SPDX-License-Identifier: MIT
/// @file
/// Descriptors 0, 1 and 2, which a program may be started without.
#pragma once

namespace raymarch
{

/// Opens /dev/null at each of 0, 1 and 2 that is closed, so that no file, device or socket of ours
/// gets one of these numbers, and with it what is meant for standard output or error. Where there
/// is no /dev/null, something that nothing can be read from or written to. Call it first in main.
/// False when not even that can be had (no descriptor is allowed).
[[nodiscard]] bool fill_standard_descriptors() noexcept;

} // namespace raymarch
