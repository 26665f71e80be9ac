// SPDX-License-Identifier: MIT
/// @file
/// Reads from the live device tree whether the board is a Zynq and whether the clock of its logic
/// runs. An access to logic without a clock stops the processor.
#pragma once

#include "base/result.hpp"
#include "board/kernel_tree.hpp"

#include <optional>

namespace raymarch::board
{

/// Returns whether this machine is a Zynq-7000, which can have the accelerator.
[[nodiscard]] bool is_zynq(const KernelTree& tree);

/// At its start Linux stops every clock that no driver uses. Returns whether the first clock of the
/// logic (FCLK0) keeps running: because of the device tree's fclk-enable, clk_ignore_unused on the
/// kernel's command line, or the vendor's driver xlnx,fclk. Returns nothing if the device tree does
/// not tell.
[[nodiscard]] std::optional<bool> keeps_logic_clock(const KernelTree& tree);

/// Errors: Unavailable, if the clock is known to be stopped.
[[nodiscard]] Result<void> require_logic_clock(const KernelTree& tree);

} // namespace raymarch::board
