// SPDX-License-Identifier: MIT
/// @file
/// Makes sure that descriptors 0, 1 and 2 are open; a program may be started without them.
#pragma once

namespace raymarch
{

/// Opens /dev/null at each of 0, 1 and 2 that is closed. Otherwise a file, device or socket of the
/// program could get one of these numbers, and with it the text for standard output or error. If
/// there is no /dev/null, something is opened that can be neither read nor written. Call it first
/// in main. Returns false if no descriptor can be opened at all.
[[nodiscard]] bool fill_standard_descriptors() noexcept;

} // namespace raymarch
