// SPDX-License-Identifier: MIT
/// @file
/// Finds the UIO devices that hold an interrupt which the overlay's devices need.
///
/// An interrupt has one owner, and the board's device tree may give it to logic that ours replaces:
/// PYNQ gives the interrupt of our registers to a device `40000000.fabric`. The kernel cannot
/// register our device then.
#pragma once

#include "base/result.hpp"
#include "board/kernel_tree.hpp"

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace raymarch::board
{

/// The driver of UIO devices with an interrupt. Its folder has a link for each device.
inline constexpr const char* uio_driver = "bus/platform/drivers/uio_pdrv_genirq";

/// A number among the shared peripheral interrupts (SPI) of the Zynq's interrupt controller.
using SharedInterrupt = std::uint32_t;

/// Returns the interrupts of a compiled overlay's nodes. Errors: BadData, with `file`.
[[nodiscard]] Result<std::vector<SharedInterrupt>>
overlay_interrupts(std::span<const std::uint8_t> blob, const std::string& file);

struct InterruptHolder
{
    std::string device; ///< the kernel's name: `40000000.fabric`
    SharedInterrupt interrupt = 0;
};

/// Returns the devices of `uio_driver` with one of `interrupts`, except the device that the device
/// tree names `own` (linux,uio-name).
[[nodiscard]] std::vector<InterruptHolder>
interrupt_holders(const KernelTree& tree, std::span<const SharedInterrupt> interrupts,
                  std::string_view own);

/// Unbinds the device from its driver, which frees its interrupt. Errors: Unavailable, InputOutput.
[[nodiscard]] Result<void> unbind(KernelTree& tree, const InterruptHolder& holder);

/// Binds the device again. Errors: Unavailable, InputOutput.
[[nodiscard]] Result<void> bind(KernelTree& tree, const InterruptHolder& holder);

} // namespace raymarch::board
