// SPDX-License-Identifier: MIT
/// @file
/// Reads the state of the programmable logic from the kernel's FPGA manager, and loads the logic.
///
/// Logic that is not configured does not answer on its bus, and a read there stops the processor.
/// So the state is checked before each access.
/// (Documentation/ABI/testing/sysfs-class-fpga-manager. Only the vendor's kernel has `flags` and
/// `firmware`, which load the logic without a device tree overlay.)
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
    std::string driver;          ///< the name that its driver gives
    std::string state;           ///< `operating`, `unknown`, `write error`, …
    bool takes_firmware = false; ///< it can load a file
    [[nodiscard]] bool operating() const { return state == "operating"; }
};

/// Returns the manager of the Zynq's logic if there is one, else the first manager.
[[nodiscard]] std::optional<FpgaManager> find_fpga_manager(const KernelTree& tree);

/// Checks that the logic may be accessed: its manager says `operating`, or there is no manager.
/// Errors: Unavailable.
[[nodiscard]] Result<void> require_operating_logic(const KernelTree& tree);

/// Loads the logic from `firmware`, a file in the kernel's firmware folder, and checks that it
/// runs. The manager's flags are restored. Precondition: `manager.takes_firmware`. Errors:
/// InputOutput, with the manager's last state.
[[nodiscard]] Result<void> load_firmware(KernelTree& tree, const FpgaManager& manager,
                                         const std::string& firmware);

} // namespace raymarch::board
