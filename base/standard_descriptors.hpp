// SPDX-License-Identifier: MIT
/// @file
/// Makes sure that descriptors 0, 1 and 2 are open; a program may be started without them.
#pragma once

namespace raymarch
{

/// Opens /dev/null at each of 0, 1 and 2 that is closed. Otherwise a file, device or socket of the
/// program could get one of these numbers, and the text for standard output or error would go to
/// it. If there is no /dev/null, the descriptor can be neither read nor written. Call this function
/// first in main. It returns false if no descriptor can be opened.
[[nodiscard]] bool fill_standard_descriptors() noexcept;

} // namespace raymarch
