// SPDX-License-Identifier: MIT
/// @file
/// What the live device tree tells of the board: whether it is a Zynq, and whether the clock of its
/// logic runs. An access to logic without a clock stops the processor, as one to no logic does.
#pragma once

#include "base/result.hpp"
#include "board/kernel_tree.hpp"

#include <optional>

namespace raymarch::board
{

/// Whether this machine is one that can have the accelerator: a Zynq-7000.
[[nodiscard]] bool is_zynq(const KernelTree& tree);

/// Whether something keeps the first clock of the logic (FCLK0) running; Linux stops at its start
/// the clocks that none of its drivers uses. Kept: by the device tree's fclk-enable, by
/// clk_ignore_unused on the kernel's command line, or by the vendor's driver for it (xlnx,fclk).
/// Nothing where the device tree does not tell.
[[nodiscard]] std::optional<bool> keeps_logic_clock(const KernelTree& tree);

/// Errors: Unavailable, where the clock is known to be stopped.
[[nodiscard]] Result<void> require_logic_clock(const KernelTree& tree);

} // namespace raymarch::board
