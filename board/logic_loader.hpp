// SPDX-License-Identifier: MIT
/// @file
/// Loads the programmable logic together with its overlay, and removes the overlay.
#pragma once

#include "base/result.hpp"
#include "board/bitstream.hpp"
#include "board/interrupt_holders.hpp"
#include "board/kernel_tree.hpp"

#include <string>
#include <vector>

namespace raymarch::board
{

/// TABLE: the names in overlay/raymarch.dtso; a test compares them.
inline constexpr const char* overlay_name = "raymarch";
inline constexpr const char* overlay_firmware = "raymarch.bin";
inline constexpr const char* overlay_uio_name = "raymarch";

/// The kernel's firmware folder, beside the root of its tree.
inline constexpr const char* firmware_folder = "lib/firmware";

/// Returns one sentence for each feature that the kernel lacks to load the logic and the overlay.
[[nodiscard]] std::vector<std::string> missing_features(const KernelTree& tree);

struct LogicFiles
{
    std::string bitstream_name; ///< for messages
    std::string bitstream;
    std::string overlay_name;
    std::string overlay;
};

/// Checks both files and the kernel. Then writes the `.bin` to the firmware folder, unbinds UIO
/// devices that hold an interrupt of the overlay, loads the logic and loads the overlay. If a step
/// fails, the earlier ones are undone, but configured logic stays configured. If the FPGA manager
/// cannot load a file, the FPGA region loads the file that the overlay names. Returns the unbound
/// devices. Errors: BadData (a file is wrong), Unavailable (the kernel lacks a feature, or the
/// overlay is already loaded), InputOutput.
[[nodiscard]] Result<std::vector<InterruptHolder>>
load_logic(KernelTree& tree, const LogicFiles& files, const LogicDevice& device = zynq_7020);

/// Removes the overlay; returns false if it is not loaded. The logic stays configured, so unbound
/// devices stay unbound. Errors: Unavailable (the kernel cannot load overlays), InputOutput.
[[nodiscard]] Result<bool> unload_logic(KernelTree& tree);

} // namespace raymarch::board
