// SPDX-License-Identifier: MIT
/// @file
/// A Pin over the kernel's GPIO character devices, by libgpiod.
#pragma once

#include "base/result.hpp"
#include "drivers/line_spec.hpp"
#include "drivers/ports.hpp"

#include <cstdint>
#include <memory>

namespace raymarch::drivers
{

enum class LineUse : std::uint8_t { Input, Output };

/// Requests the first of the line's places that is there, for this process alone. An output starts
/// dark (inactive); an input reports both edges where its chip has an interrupt for it.
/// Errors: Unavailable, with ENODEV when this machine has no GPIO chip at all: no line of that
/// name, no chip of that label or path, no such offset, a line that is in use, or a wiring that the
/// chip does not have.
[[nodiscard]] Result<std::unique_ptr<Pin>> open_gpio_line(const LineSpec& spec, LineUse use);

} // namespace raymarch::drivers
