// SPDX-License-Identifier: MIT
/// @file
/// Opens a GPIO line with libgpiod.
#pragma once

#include "base/result.hpp"
#include "drivers/line_spec.hpp"
#include "drivers/ports.hpp"

#include <cstdint>
#include <memory>

namespace raymarch::drivers
{

enum class LineUse : std::uint8_t { Input, Output };

/// Requests the first place in `spec` that exists; the line is exclusive to this process. An output
/// starts inactive. An input reports both edges if its chip has an interrupt for it.
/// Errors: Unavailable (no such line, chip or offset; the line is in use; the chip cannot wire it
/// that way). `number` is ENODEV if this machine has no GPIO chip.
[[nodiscard]] Result<std::unique_ptr<Pin>> open_gpio_line(const LineSpec& spec, LineUse use);

} // namespace raymarch::drivers
