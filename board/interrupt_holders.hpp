// SPDX-License-Identifier: MIT
/// @file
/// The UIO devices that hold an interrupt which the overlay's devices want.
///
/// Such an interrupt has one owner, and a board's own device tree may have given it to logic that
/// ours replaces: PYNQ's gives that of our registers to a device `40000000.fabric`. With it there
/// ours is not registered.
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

/// The driver of UIO devices with an interrupt; its folder has a link for each of them.
inline constexpr const char* uio_driver = "bus/platform/drivers/uio_pdrv_genirq";

/// A number among the shared peripheral interrupts (SPI) of the Zynq's interrupt controller.
using SharedInterrupt = std::uint32_t;

/// Those of a compiled overlay's nodes. Errors: BadData, with `file`.
[[nodiscard]] Result<std::vector<SharedInterrupt>>
overlay_interrupts(std::span<const std::uint8_t> blob, const std::string& file);

struct InterruptHolder
{
    std::string device; ///< as the kernel calls it: `40000000.fabric`
    SharedInterrupt interrupt = 0;
};

/// The devices of `uio_driver` with one of `interrupts`, but for that which the device tree names
/// `own` (linux,uio-name).
[[nodiscard]] std::vector<InterruptHolder>
interrupt_holders(const KernelTree& tree, std::span<const SharedInterrupt> interrupts,
                  std::string_view own);

/// Takes the device away from its driver, and so its interrupt. Errors: Unavailable, InputOutput.
[[nodiscard]] Result<void> unbind(KernelTree& tree, const InterruptHolder& holder);

/// Gives it back. Errors: Unavailable, InputOutput.
[[nodiscard]] Result<void> bind(KernelTree& tree, const InterruptHolder& holder);

} // namespace raymarch::board
