// SPDX-License-Identifier: MIT
/// @file
/// The programmable logic and its overlay, loaded together and taken away again: the steps, their
/// order, and what is undone when one of them fails.
#pragma once

#include "base/result.hpp"
#include "board/bitstream.hpp"
#include "board/interrupt_holders.hpp"
#include "board/kernel_tree.hpp"

#include <string>
#include <vector>

namespace raymarch::board
{

/// TABLE: what the overlay calls things; overlay/raymarch.dtso says the same, by a test.
inline constexpr const char* overlay_name = "raymarch";
inline constexpr const char* overlay_firmware = "raymarch.bin";
inline constexpr const char* overlay_uio_name = "raymarch";

/// Where the kernel looks for firmware, beside the root of its tree.
inline constexpr const char* firmware_folder = "lib/firmware";

/// What the kernel would need to load the logic and the overlay while it runs; a sentence each,
/// none where it has all.
[[nodiscard]] std::vector<std::string> missing_features(const KernelTree& tree);

/// Two files, read.
struct LogicFiles
{
    std::string bitstream_name; ///< for messages
    std::string bitstream;
    std::string overlay_name;
    std::string overlay;
};

/// Checks both files and the kernel, and only then: the `.bin` into the firmware folder, UIO
/// devices with an interrupt of the overlay's unbound, the logic, the overlay. A step that fails
/// undoes those before it; logic that has been configured stays so. On a kernel whose FPGA manager
/// takes no file, the FPGA region loads the one that the overlay names. Returns what has been
/// unbound. Errors: BadData (a file), Unavailable (the kernel; loaded already), InputOutput.
[[nodiscard]] Result<std::vector<InterruptHolder>>
load_logic(KernelTree& tree, const LogicFiles& files, const LogicDevice& device = zynq_7020);

/// Takes the overlay away; false when it is not there. The logic stays configured, so what gave way
/// to it is not bound again: its own logic is gone. Errors: Unavailable (the kernel knows no
/// overlays), InputOutput.
[[nodiscard]] Result<bool> unload_logic(KernelTree& tree);

} // namespace raymarch::board
