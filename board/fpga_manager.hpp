// SPDX-License-Identifier: MIT
/// @file
/// The kernel's FPGA manager: what state the programmable logic is in, and loading it.
///
/// Logic that is not configured does not answer its bus, and a processor that reads there stops
/// with the whole board. So whoever wants to touch it asks here first.
/// (Documentation/ABI/testing/sysfs-class-fpga-manager; `flags` and `firmware` are of the board
/// vendor's kernel, where a device tree overlay is not the only way to load the logic.)
#pragma once

#include "base/result.hpp"
#include "board/kernel_tree.hpp"

#include <optional>
#include <string>

namespace raymarch::board
{

struct FpgaManager
{
    std::string folder;          ///< `class/fpga_manager/fpga0`
    std::string driver;          ///< what its driver calls it
    std::string state;           ///< `operating`, `unknown`, `write error`, …
    bool takes_firmware = false; ///< it can be told to load a file
    [[nodiscard]] bool operating() const { return state == "operating"; }
};

/// The manager of the processor's own logic: a Zynq's where there is one, else the first.
[[nodiscard]] std::optional<FpgaManager> find_fpga_manager(const KernelTree& tree);

/// Whether the logic may be touched: its manager says `operating`, or there is no manager to ask.
/// Errors: Unavailable.
[[nodiscard]] Result<void> require_operating_logic(const KernelTree& tree);

/// Loads the whole logic from `firmware`, a file in the kernel's firmware folder, and sees that it
/// runs. The manager's flags are as before afterwards. Precondition: `manager.takes_firmware`.
/// Errors: InputOutput, with the state that the manager ended in.
[[nodiscard]] Result<void> load_firmware(KernelTree& tree, const FpgaManager& manager,
                                         const std::string& firmware);

} // namespace raymarch::board
